#include "case/press/check_overlaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "core/index.hpp"
#include "dynamics/laws/contact_law.hpp"
#include "packing/near_pairs.hpp"

namespace superstep::dynamics {
namespace {

/// Two particles, or one and a wall.
struct Overlap {
  double strain = 0;  ///< of the sum of the radii, of the radius
  std::size_t a = 0, b = 0;
  std::optional<Wall> wall;
};

Overlap deepest_overlap(const ModelInput& input) {
  const auto& position = input.state.position;
  const auto& radius = input.particles.radius;
  Overlap deepest;
  for (const auto& [i, j] : near_pairs(position, radius)) {
    const std::size_t a = at(i), b = at(j);
    const double strain = -pair_strain(norm(position[b] - position[a]), radius[a] + radius[b]);
    if (strain > deepest.strain) deepest = {strain, a, b, std::nullopt};
  }
  std::vector<WallContact> walls;
  find_wall_contacts(input.model.box, input.model.box.max.z, position, radius, walls);
  for (const auto& contact : walls)
    if (-contact.strain > deepest.strain) deepest = {-contact.strain, at(contact.particle), 0, contact.wall};
  return deepest;
}

std::string particle_at(const ModelInput& input, std::size_t i) {
  const Vec3& centre = input.state.position[i];
  return fmt::format("particle {} at ({:.6g}, {:.6g}, {:.6g}) m", input.particles.id[i], centre.x, centre.y,
                     centre.z);
}

std::string in_words(const ModelInput& input, const Overlap& one) {
  if (one.wall)
    return fmt::format("{} overlaps the {} wall by {:.4g} of its radius", particle_at(input, one.a),
                       wall_name(*one.wall), one.strain);
  return fmt::format("{} and {} overlap by {:.4g} of the sum of their radii", particle_at(input, one.a),
                     particle_at(input, one.b), one.strain);
}

/// Four digits that are not smaller than a number > 0.
double rounded_up(double value) {
  const double last = std::pow(10.0, std::floor(std::log10(value)) - 3);
  return std::ceil(value / last) * last;
}

}  // namespace

void check_overlaps(const ModelInput& input, std::optional<double> allowed, const std::string& place) {
  constexpr double rounding = 1e-9;  // particles that just touch do not overlap
  const Overlap deepest = deepest_overlap(input);
  if (deepest.strain <= std::max(allowed.value_or(0), rounding)) return;
  const std::string limit =
      allowed ? fmt::format("max_overlap is {}", *allowed) : "without max_overlap they may touch and no more";
  const double enough = rounded_up(deepest.strain);
  const std::string other_way =
      enough < 1 ? fmt::format(", or allow it with max_overlap = {:.4g}", enough) : "";
  throw InputError(fmt::format("{}: {} at the start, deeper than all others, and {}; move them apart{}",
                               place, in_words(input, deepest), limit, other_way));
}

}  // namespace superstep::dynamics
