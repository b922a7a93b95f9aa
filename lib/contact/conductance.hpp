#pragma once
/// Conductance of a contact: heat [W/K] from thermal conductivities [W/(m K)], current [S] from electric ones
/// [S/m].

namespace superstep {

/// Grain boundary between two particles.
struct Interface {
  double thickness = 0;  ///< m; 0 = there is none
  double reduction = 1;  ///< its conductivity as a fraction of the particles', 0 to 1
};

/// Particle, grain boundary and particle in series: 1/K = 1/K_i + 1/K_j + 1/K_c, K_i = 1.08 kappa_i pi a,
/// K_c = reduction * kappa_eq pi a^2/thickness with kappa_eq the harmonic mean. Conductivities and neck
/// radius a > 0. Source: Rojek & Nisar (2026), eqs 31-33 and 38-39.
[[nodiscard]] double series_conductance(double kappa_i, double kappa_j, double neck_radius,
                                        const Interface& interface = {}) noexcept;

/// Straight pipe of the neck's cross-section from centre to centre: K = kappa_mean pi a^2/distance.
/// Source: Zohdi (2014), eqs 33-34; the mean of unequal conductivities is the arithmetic one.
[[nodiscard]] double pipe_conductance(double kappa_i, double kappa_j, double neck_radius,
                                      double distance) noexcept;

}  // namespace superstep
