#pragma once
/// Network health: what a user should know about a scene before spending time on it.

#include <optional>
#include <string>
#include <vector>

#include "case/checks/effective.hpp"
#include "case/scene.hpp"

namespace superstep {

struct FieldHealth {
  std::string name, unit;
  bool steady = false;  ///< solved for: it has no capacities, so that nothing below is said of stiffness
  /// "300 to 400 K": the temperatures at the start, which everything below is for; empty where conductivities
  /// do not follow them.
  std::string temperatures;
  std::size_t nodes = 0, edges = 0, free = 0, fixed = 0, idle = 0, eliminated = 0;
  std::size_t components = 0, floating = 0, idle_clusters = 0, isolated = 0;
  double coordination_mean = 0;
  std::size_t coordination_min = 0, coordination_max = 0;
  double pair_step_bare = 0;              ///< s, particle contributions only
  double pair_step_full = 0;              ///< s, with the interface term
  double edge_bound = 0, gershgorin = 0;  ///< 1/s
  /// 1/s, of the Jacobian of the whole scene at its start; only where conductivities follow the temperature,
  /// so that there is more to it than the conductances of which the two bounds are.
  std::optional<double> jacobian_bound;
  double lambda_max = 0;  ///< 1/s, Lanczos, of the conductances and what convects and radiates
  double lambda_max_residual = 0;
  std::optional<double>
      lambda_min;  ///< 1/s, shift-invert Lanczos; absent when a cluster floats or the fill is too large
  std::string lambda_min_note;
  std::optional<double> effective_conductivity;     ///< W/(m K) or S/m
  std::optional<double> effective_periodic;         ///< the same under a mean gradient over the cell
  std::string effective_note;                       ///< why there is none, or why it is 0
  std::string effective_basis;                      ///< its length and cross-section, with advice about them
  double effective_length = 0, effective_area = 0;  ///< m, m2; 0 where `effective_basis` is empty
  std::optional<ElectrodeFacts> electrodes;         ///< of a potential between two electrodes
  double conductance_min = 0, conductance_max = 0;  ///< W/K or S
  std::optional<double>
      lumping_median;  ///< of K_ij / (pi kappa R_min): not small means that lumping is coarse

  [[nodiscard]] double critical_step() const noexcept { return 2 / lambda_max; }
  [[nodiscard]] double certified_step() const noexcept;
};

struct PackingHealth {
  std::size_t particles = 0, contacts = 0;
  double diameter_min = 0, diameter_max = 0;                   ///< m
  std::optional<double> relative_density;                      ///< of the stated container
  double overlap_median = 0, overlap_95 = 0, overlap_max = 0;  ///< of the smaller radius
  std::size_t saturated = 0, limited = 0;
};

struct NetworkHealth {
  std::optional<PackingHealth> packing;
  std::vector<FieldHealth> fields;
};

/// Computes everything at the start of the scene; costs some tens of sweeps and one factorization per field.
[[nodiscard]] NetworkHealth assess_network(const Scene& scene);

}  // namespace superstep
