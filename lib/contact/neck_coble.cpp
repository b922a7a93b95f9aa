#include <cmath>

#include "contact/neck_laws.hpp"

namespace superstep {
namespace {

double radius(double r_i, double r_j, double overlap, const NeckParameters&) {
  return std::sqrt(2.0 * effective_radius(r_i, r_j) * overlap);
}

}  // namespace

NeckLaw neck_coble() {
  return {"coble", "a^2 = 2 r_eff h", "Rojek & Nisar (2026), eq. 37", {}, radius};
}

}  // namespace superstep
