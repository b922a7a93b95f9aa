#include "dynamics/random_addition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "core/random.hpp"

namespace superstep::dynamics {
namespace {

constexpr int most_attempts = 1'000'000;
constexpr std::size_t between_reports = 1 << 17;  // attempts; some hundredths of a second

double volume_of(const Box& box) {
  const Vec3 size = box.max - box.min;
  return size.x * size.y * size.z;
}

/// Bins as wide as a diameter or wider, each with the spheres whose centres lie in it.
class Bins {
 public:
  Bins(const Box& box, double radius, std::size_t spheres) : origin_(box.min) {
    const Vec3 size = box.max - box.min;
    const std::array<double, 3> lengths = {size.x, size.y, size.z};
    // More bins than a few for each sphere would only cost memory in a box that is nearly empty.
    constexpr double for_each = 4, most = 256;
    const double width =
        std::max(2 * radius, std::cbrt(volume_of(box) / (for_each * static_cast<double>(spheres))));
    for (std::size_t k = 0; k < 3; ++k) {
      count_[k] = static_cast<std::size_t>(std::clamp(std::floor(lengths[k] / width), 1.0, most));
      width_[k] = lengths[k] / static_cast<double>(count_[k]);
    }
    members_.resize(count_[0] * count_[1] * count_[2]);
  }

  [[nodiscard]] bool free(Vec3 centre, double radius) const {
    const auto cell = cell_of(centre);
    for (std::size_t z = below(cell[2]); z <= above(cell[2], 2); ++z)
      for (std::size_t y = below(cell[1]); y <= above(cell[1], 1); ++y)
        for (std::size_t x = below(cell[0]); x <= above(cell[0], 0); ++x)
          for (const auto& other : members_[index({x, y, z})]) {
            const Vec3 between = other.centre - centre;
            const double sum = other.radius + radius;
            if (dot(between, between) < sum * sum) return false;
          }
    return true;
  }

  void add(Vec3 centre, double radius) { members_[index(cell_of(centre))].push_back({centre, radius}); }

 private:
  struct Sphere {
    Vec3 centre;
    double radius;
  };
  using Cell = std::array<std::size_t, 3>;
  [[nodiscard]] Cell cell_of(Vec3 point) const {
    const Vec3 from = point - origin_;
    const std::array<double, 3> distance = {from.x, from.y, from.z};
    Cell cell{};
    for (std::size_t k = 0; k < 3; ++k)
      cell[k] = std::min(static_cast<std::size_t>(distance[k] / width_[k]), count_[k] - 1);
    return cell;
  }
  [[nodiscard]] std::size_t index(const Cell& cell) const {
    return (cell[2] * count_[1] + cell[1]) * count_[0] + cell[0];
  }
  [[nodiscard]] static std::size_t below(std::size_t cell) { return cell == 0 ? 0 : cell - 1; }
  [[nodiscard]] std::size_t above(std::size_t cell, std::size_t axis) const {
    return std::min(cell + 1, count_[axis] - 1);
  }

  Vec3 origin_;
  Cell count_{};
  std::array<double, 3> width_{};
  std::vector<std::vector<Sphere>> members_;
};

/// Volume of the spheres over that of the box.
double volume_fraction_of(const Box& box, const std::vector<double>& radii) {
  double volume = 0;
  for (const double r : radii) volume += 4 * std::numbers::pi / 3 * r * r * r;
  return volume / volume_of(box);
}

[[noreturn]] void no_room(const std::string& what, double fraction) {
  throw NumericalError(fmt::format(
      "random sequential addition {}; the count asks for a volume fraction of {:.3f}, and the method "
      "jams at 0.38: take fewer or smaller spheres, or a larger box",
      what, fraction));
}

/// Refuses what no arrangement can be: equal spheres fill at most pi/sqrt(18) of a box, others less than all.
void require_possible(const Box& box, const std::vector<double>& radii, double largest) {
  const double smallest = *std::min_element(radii.begin(), radii.end());
  const double most = smallest == largest ? std::numbers::pi / std::sqrt(18.0) : 1.0;
  constexpr double rounding = 1e-9;
  if (const double fraction = volume_fraction_of(box, radii); fraction > most * (1 + rounding))
    no_room(fmt::format("found no room for {} spheres, nor would any arrangement of them", radii.size()),
            fraction);
}

}  // namespace

std::vector<Vec3> random_addition(const Box& box, std::size_t count, double radius, std::uint64_t seed) {
  return random_addition(box, std::vector<double>(count, radius), seed);
}

std::vector<Vec3> random_addition(const Box& box, const std::vector<double>& radii, std::uint64_t seed,
                                  const Placed& placed) {
  if (radii.empty()) return {};
  const double largest = *std::max_element(radii.begin(), radii.end());
  Random random(seed);
  Bins bins(box, largest, radii.size());
  std::vector<Vec3> centres;
  std::size_t all_attempts = 0;
  for (const double radius : radii) {
    const Vec3 low = box.min + radius * Vec3{1, 1, 1}, high = box.max - radius * Vec3{1, 1, 1};
    if (!(low.x <= high.x && low.y <= high.y && low.z <= high.z))
      throw NumericalError(
          fmt::format("a sphere of radius {} m does not fit into the box; take a smaller radius", radius));
    if (centres.empty()) require_possible(box, radii, largest);
    int attempts = 0;
    Vec3 centre;
    do {
      if (++attempts > most_attempts) {
        no_room(fmt::format("placed {} of {} spheres and found no room for the next in {} attempts",
                            centres.size(), radii.size(), most_attempts),
                volume_fraction_of(box, radii));
      }
      if (++all_attempts % between_reports == 0 && placed)
        placed(static_cast<double>(centres.size()) / static_cast<double>(radii.size()));
      centre = {random.uniform(low.x, high.x), random.uniform(low.y, high.y), random.uniform(low.z, high.z)};
    } while (!bins.free(centre, radius));
    bins.add(centre, radius);
    centres.push_back(centre);
  }
  return centres;
}

}  // namespace superstep::dynamics
