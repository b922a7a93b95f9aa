#include <cmath>

#include "contact/neck_laws.hpp"

namespace superstep {
namespace {

double radius(double r_i, double r_j, double overlap, const NeckParameters& parameters) {
  return std::sqrt(parameters.hardening * effective_radius(r_i, r_j) * overlap);
}

}  // namespace

NeckLaw neck_plastic() {
  return {"plastic", "a^2 = hardening r_eff h", "Rojek & Nisar (2026), eq. 36", {"hardening"}, radius};
}

}  // namespace superstep
