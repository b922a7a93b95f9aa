/// Two spheres joined by a straight cylindrical neck of radius a; their total volume is that of the separate
/// spheres. With u = a^2 and z_i = sqrt(r_i^2 - u), volume is kept when  overlap = u * sum phi_i.

#include <algorithm>
#include <cmath>

#include "contact/neck_laws.hpp"

namespace superstep {
namespace {

/// One sphere's part of the overlap, u * phi, and the slope of that part, psi. Free of cancellation for small
/// u.
struct Share {
  double phi, psi;  // 1/m
};

Share share(double r, double u) noexcept {
  const double z = std::sqrt(std::max(0.0, r * r - u));
  const double scale = 1.0 / (3.0 * (r + z) * (r + z));
  return {(r + 2.0 * z) * scale, (2.0 * r + z) * scale};
}

double overlap_at(double r_i, double r_j, double u) noexcept {
  return u * (share(r_i, u).phi + share(r_j, u).phi);
}

double radius(double r_i, double r_j, double overlap, const NeckParameters&) {
  const double smaller = std::min(r_i, r_j);
  if (overlap >= saturation_overlap(r_i, r_j)) return smaller;
  // u * sum phi is convex and the start lies beyond the root, so that Newton's iterates fall monotonically;
  // six steps are enough for radius ratios up to 100 and overlaps from 1e-15 of the smaller radius.
  double u = std::min(2.0 * effective_radius(r_i, r_j) * overlap, smaller * smaller);
  constexpr int most_steps = 20;
  for (int step = 0; step < most_steps; ++step) {
    const Share i = share(r_i, u), j = share(r_j, u);
    const double correction = (u * (i.phi + j.phi) - overlap) / (i.psi + j.psi);
    u -= correction;
    if (!(correction > 1e-15 * u)) break;
  }
  return std::sqrt(u);
}

}  // namespace

double saturation_overlap(double r_i, double r_j) noexcept {
  const double smaller = std::min(r_i, r_j);
  return overlap_at(r_i, r_j, smaller * smaller);
}

NeckLaw neck_volume_preserving() {
  return {"volume-preserving",
          "h = a^2 sum (r + 2 z)/(3 (r + z)^2), z = sqrt(r^2 - a^2), over both spheres",
          "Rojek & Nisar (2026), text after eq. 37",
          {},
          radius};
}

}  // namespace superstep
