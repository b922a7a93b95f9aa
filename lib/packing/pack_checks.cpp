#include "packing/pack_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/error.hpp"

namespace superstep {
namespace {

void require(bool holds, std::string_view what, double value, std::string_view rule) {
  if (!holds) throw UsageError(fmt::format("packing: {} is {}; {}", what, value, rule));
}

/// Far beyond anything that is packed; volumes and their sums are numbers in between.
void require_length(double value, std::string_view what) {
  constexpr double smallest = 1e-15, largest = 1e9;  // m
  require(value >= smallest && value <= largest, what, value,
          "it must be a length > 0 in metres, from 1e-15 to 1e9 m");
}

void check_container(const Container& container) {
  require_length(container.height, "container height");
  if (container.shape == Container::Shape::cylinder) {
    require_length(container.diameter, "container diameter");
  } else {
    require_length(container.width, "container width");
    require_length(container.depth, "container depth");
  }
}

double narrowest(const Container& container) {
  return container.shape == Container::Shape::cylinder
             ? std::min(container.diameter, container.height)
             : std::min({container.width, container.depth, container.height});
}

void check_list(const SizeDistribution& sizes) {
  if (sizes.diameters.empty()) throw UsageError("packing: the list of diameters is empty; give at least one");
  if (!sizes.weights.empty() && sizes.weights.size() != sizes.diameters.size())
    throw UsageError(
        fmt::format("packing: {} weights for {} diameters; give one weight per diameter, or none",
                    sizes.weights.size(), sizes.diameters.size()));
  for (const double diameter : sizes.diameters) require_length(diameter, "a listed diameter");
  constexpr double lightest = 1e-40, heaviest = 1e40;  // their sum is a number
  for (const double weight : sizes.weights)
    require(weight >= lightest && weight <= heaviest, "a weight", weight, "weights are number fractions > 0");
}

/// Returns the largest diameter.
double check_sizes(const SizeDistribution& sizes, bool fit_median) {
  if (sizes.kind == SizeDistribution::Kind::list) {
    check_list(sizes);
    return *std::max_element(sizes.diameters.begin(), sizes.diameters.end());
  }
  require_length(sizes.min, "smallest diameter");
  require_length(sizes.max, "largest diameter");
  const bool lognormal = sizes.kind == SizeDistribution::Kind::lognormal;
  require(lognormal ? sizes.max > sizes.min : sizes.max >= sizes.min, "largest diameter", sizes.max,
          fmt::format("it must exceed the smallest, {} m", sizes.min));
  if (!lognormal) return sizes.max;
  require(sizes.sigma >= narrowest_sigma && sizes.sigma <= widest_sigma, "sigma", sizes.sigma,
          "the standard deviation of ln(diameter) must be > 0, from 1e-3 to 10; for equal spheres use a "
          "uniform distribution");
  if (!fit_median)
    require(
        sizes.median >= sizes.min && sizes.median <= sizes.max, "median diameter", sizes.median,
        fmt::format(
            "it must lie between the cut-offs {} and {} m; or give a count and leave the median to be fitted",
            sizes.min, sizes.max));
  return sizes.max;
}

}  // namespace

void check_pack_settings(const PackSettings& settings) {
  check_container(settings.container);
  constexpr double densest = 0.9;  // beyond, overlap relaxation loses small spheres inside large ones
  require(settings.relative_density > 0 && settings.relative_density <= densest, "relative density",
          settings.relative_density,
          "it must be > 0 and at most 0.9 (sum of sphere volumes over container volume)");
  constexpr double deepest = 0.5;
  require(settings.bond_overlap >= 0 && settings.bond_overlap <= deepest, "bond overlap",
          settings.bond_overlap, "it must lie between 0 (no bonds) and 0.5 of the smaller radius");
  const bool lognormal = settings.sizes.kind == SizeDistribution::Kind::lognormal;
  if (settings.count > 0 && !lognormal)
    throw UsageError(
        fmt::format("packing: a count ({}) goes with lognormal sizes only, whose median it fits; for other "
                    "sizes the count follows from the relative density",
                    settings.count));
  if (settings.count > largest_packing)
    throw UsageError(
        fmt::format("packing: count is {}; at most {} are allowed", settings.count, largest_packing));
  const double largest = check_sizes(settings.sizes, settings.count > 0),
               room = narrowest(settings.container);
  require(largest <= room, "largest diameter", largest,
          fmt::format("it must fit into the container, whose narrowest side is {} m", room));
}

}  // namespace superstep
