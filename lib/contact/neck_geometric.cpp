#include <algorithm>
#include <cmath>

#include "contact/neck_laws.hpp"

namespace superstep {
namespace {

double radius(double r_i, double r_j, double overlap, const NeckParameters&) {
  const double distance = r_i + r_j - overlap;
  // (r_i^2 - L_i^2) 4 d^2 as a product: no cancellation however small the overlap is.
  const double product = overlap * (r_i + r_j + distance) * (distance - r_i + r_j) * (distance + r_i - r_j);
  return std::sqrt(std::max(0.0, product)) / (2.0 * distance);
}

}  // namespace

NeckLaw neck_geometric() {
  return {"geometric",
          "a^2 = r_i^2 - L_i^2, L_i = (d - (r_j^2 - r_i^2)/d)/2",
          "Zohdi (2014), eqs 7-12",
          {},
          radius};
}

}  // namespace superstep
