#include "contact/conductance.hpp"

#include <numbers>

namespace superstep {

double series_conductance(double kappa_i, double kappa_j, double neck_radius,
                          const Interface& interface) noexcept {
  using std::numbers::pi;
  constexpr double shape_factor = 1.08;  // fitted to sintered spheres in the source
  const double particle_i = shape_factor * kappa_i * pi * neck_radius;
  const double particle_j = shape_factor * kappa_j * pi * neck_radius;
  double resistance = 1.0 / particle_i + 1.0 / particle_j;
  if (interface.thickness > 0) {
    const double kappa_eq = 2.0 * kappa_i * kappa_j / (kappa_i + kappa_j);
    resistance += interface.thickness / (interface.reduction * kappa_eq * pi * neck_radius * neck_radius);
  }
  return 1.0 / resistance;
}

double pipe_conductance(double kappa_i, double kappa_j, double neck_radius, double distance) noexcept {
  return 0.5 * (kappa_i + kappa_j) * std::numbers::pi * neck_radius * neck_radius / distance;
}

}  // namespace superstep
