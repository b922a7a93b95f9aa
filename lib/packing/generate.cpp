#include "packing/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

#include "core/error.hpp"
#include "core/random.hpp"
#include "packing/near_pairs.hpp"
#include "packing/pack_checks.hpp"
#include "packing/relaxation/relax.hpp"
#include "packing/relaxation/seat_loners.hpp"
#include "packing/relaxation/size_distribution.hpp"

namespace superstep {
namespace {

/// Twelve significant digits: text files stay short and give back the very same packing, and differences in
/// the last digit, of mathematical libraries or of lengths that came in other units, do not grow into other
/// packings.
double rounded(double value) {
  const std::string text = fmt::format("{:.11e}", value);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Gives ascending diameters this volume by one factor, and leaves none of them beyond the cut-offs nor a
/// lognormal without its extremes. Listed and equal ones, and those whose cut-offs are too close together for
/// the volume, all take the factor.
void correct_volume(const SizeDistribution& sizes, double volume, double largest_correction,
                    std::vector<double>& diameters) {
  const bool has_width = sizes.kind != SizeDistribution::Kind::list && sizes.max > sizes.min;
  const auto scaled = [&](double factor) {
    auto out = diameters;
    for (double& d : out) d = std::clamp(factor * d, sizes.min, sizes.max);
    if (sizes.kind == SizeDistribution::Kind::lognormal) {
      out.front() = diameters.front();
      out.back() = diameters.back();
    }
    return out;
  };
  double low = 1 - largest_correction, high = 1 + largest_correction;
  const auto volume_at = [&](double factor) { return volume_of_diameters(scaled(factor)); };
  if (has_width && volume_at(low) <= volume && volume <= volume_at(high)) {
    constexpr int halvings = 50;
    for (int k = 0; k < halvings; ++k) {
      const double middle = 0.5 * (low + high);
      (volume_at(middle) < volume ? low : high) = middle;
    }
    diameters = scaled(high);
    return;
  }
  const double factor = std::cbrt(volume / volume_of_diameters(diameters));  // about 1 +- 1/(6 count)
  for (double& d : diameters) d *= factor;
}

/// Final radii in random order; their volume hits the relative density.
std::vector<double> draw_radii(const PackSettings& settings, Random& random) {
  const double volume = settings.relative_density * settings.container.volume();
  SizeDistribution sizes = settings.sizes;
  std::size_t count = settings.count;
  if (count == 0)
    count = count_for_volume(sizes, volume, largest_packing);
  else
    sizes.median = median_for_volume(sizes, count, volume);
  auto radii = stratified_diameters(sizes, count);                           // diameters yet
  const double correction = std::cbrt(volume / volume_of_diameters(radii));  // about 1 +- 1/(6 count)
  constexpr double largest_correction = 0.02;
  if (std::abs(correction - 1.0) > largest_correction)
    throw UsageError(
        fmt::format("packing: {} spheres of these sizes miss the relative density {} by {:.2g} % of their "
                    "diameters; choose a larger container or smaller spheres",
                    count, settings.relative_density, 100.0 * std::abs(correction - 1.0)));
  correct_volume(sizes, volume, largest_correction, radii);
  for (double& r : radii) r = rounded(0.5 * r);
  random.shuffle(radii);
  return radii;
}

/// Random points in the container, sorted so that neighbours in space are neighbours in memory.
std::vector<Vec3> draw_centres(const Container& container, std::size_t count, Random& random) {
  const bool round = container.shape == Container::Shape::cylinder;
  const double half_x = 0.5 * (round ? container.diameter : container.width);
  const double half_y = 0.5 * (round ? container.diameter : container.depth);
  std::vector<Vec3> centres;
  centres.reserve(count);
  while (centres.size() < count) {
    const double x = random.uniform(-half_x, half_x), y = random.uniform(-half_y, half_y);
    const double z = random.uniform(0.0, container.height);
    if (!round || x * x + y * y < half_x * half_x) centres.push_back({x, y, z});
  }
  const double block = 2.0 * std::cbrt(container.volume() / static_cast<double>(count));
  const auto key = [block](Vec3 c) {
    return std::tuple(std::floor(c.z / block), std::floor(c.y / block), c.x);
  };
  std::sort(centres.begin(), centres.end(), [&](Vec3 a, Vec3 b) { return key(a) < key(b); });
  return centres;
}

/// Grows the spheres from a dilute start, then lets the forces balance. Returns the number of relaxation
/// steps.
std::size_t grow(SoftSpheres& spheres, const PackSettings& settings,
                 const std::function<bool(double)>& progress) {
  constexpr int stages = 30, steps_per_stage = 20, batches = 20, steps_per_batch = 50;
  constexpr double first_density = 0.25;  // of the final one
  constexpr double balanced = 3e-3;       // net forces / contact forces; contacts hardly change below this
  const auto report = [&](int done) {
    if (progress && !progress(static_cast<double>(done) / (stages + batches)))
      throw NumericalError("packing: stopped before it was finished");
  };
  std::size_t steps = 0;
  for (int stage = 0; stage < stages; ++stage) {
    const double density = first_density + (1.0 - first_density) * stage / stages;
    spheres.grow_to(std::cbrt(density));
    steps += spheres.relax(steps_per_stage, 0.0);
    report(stage + 1);
  }
  spheres.grow_to(1.0);
  if (settings.bond_overlap > 0) spheres.set_adhesion({settings.bond_overlap, bond_range});
  for (int batch = 0; batch < batches; ++batch) {
    const std::size_t taken = spheres.relax(steps_per_batch, balanced);
    steps += taken;
    report(stages + batch + 1);
    if (taken < steps_per_batch) break;
  }
  return steps;
}

/// Largest overlap as a fraction of the smaller radius. Throws NumericalError when a sphere swallows another.
double largest_overlap(const Packing& packing) {
  double largest = 0;
  std::size_t swallowed = 0;
  for (const auto [first, second] : near_pairs(packing.centre, packing.radius)) {
    const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
    const double distance = norm(packing.centre[i] - packing.centre[j]);
    const double smaller = std::min(packing.radius[i], packing.radius[j]);
    if (distance <= std::abs(packing.radius[i] - packing.radius[j])) ++swallowed;
    largest = std::max(largest, (packing.radius[i] + packing.radius[j] - distance) / smaller);
  }
  if (swallowed > 0)
    throw NumericalError(
        fmt::format("packing: {} spheres ended inside larger ones; lower the relative density, narrow "
                    "the sizes or try another seed",
                    swallowed));
  return largest;
}

}  // namespace

double Container::cross_section() const noexcept {
  return shape == Shape::cylinder ? 0.25 * std::numbers::pi * diameter * diameter : width * depth;
}

double Container::volume() const noexcept {
  return cross_section() * height;
}

Packing generate_packing(const PackSettings& asked, PackReport* report,
                         const std::function<bool(double)>& progress) {
  check_pack_settings(asked);
  PackSettings settings = asked;
  Container& box = settings.container;
  for (double* length : {&box.diameter, &box.width, &box.depth, &box.height}) *length = rounded(*length);
  Random random(settings.seed);
  Packing packing;
  packing.radius = draw_radii(settings, random);
  SoftSpheres spheres(settings.container, draw_centres(settings.container, packing.size(), random),
                      packing.radius);
  const std::size_t steps = grow(spheres, settings, progress);
  packing.centre = spheres.centres();
  if (settings.bond_overlap > 0)
    seat_loners(settings.container, settings.bond_overlap, packing.radius, packing.centre);
  for (auto& [x, y, z] : packing.centre) x = rounded(x), y = rounded(y), z = rounded(z);
  packing.id.resize(packing.size());
  std::iota(packing.id.begin(), packing.id.end(), 0);
  packing.material.assign(packing.size(), 0);
  const double overlap = largest_overlap(packing);
  if (report != nullptr)
    *report = {sphere_volume(packing) / settings.container.volume(), overlap, steps, spheres.imbalance()};
  return packing;
}

}  // namespace superstep
