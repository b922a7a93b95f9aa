#include <cmath>

#include "contact/neck_laws.hpp"

namespace superstep {
namespace {

double radius(double r_i, double r_j, double overlap, const NeckParameters&) {
  return std::sqrt(0.5 * effective_radius(r_i, r_j) * overlap);
}

}  // namespace

NeckLaw neck_hertz() {
  return {"hertz", "a^2 = 0.5 r_eff h", "Rojek & Nisar (2026), eq. 34", {}, radius};
}

}  // namespace superstep
