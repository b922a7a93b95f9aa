#include "packing/relaxation/size_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/error.hpp"

namespace superstep {
namespace {

double stratum_centre(std::size_t k, std::size_t n) {
  return (static_cast<double>(k) + 0.5) / static_cast<double>(n);
}

std::vector<double> uniform_diameters(const SizeDistribution& sizes, std::size_t n) {
  std::vector<double> out(n);
  for (std::size_t k = 0; k < n; ++k) out[k] = sizes.min + (sizes.max - sizes.min) * stratum_centre(k, n);
  return out;
}

std::vector<double> listed_diameters(const SizeDistribution& sizes, std::size_t n) {
  std::vector<std::pair<double, double>> classes;  // diameter, weight
  for (std::size_t k = 0; k < sizes.diameters.size(); ++k)
    classes.emplace_back(sizes.diameters[k], sizes.weights.empty() ? 1.0 : sizes.weights[k]);
  std::sort(classes.begin(), classes.end());
  double total = 0;
  for (const auto& entry : classes) total += entry.second;
  std::vector<double> out(n);
  std::size_t current = 0;
  double below = classes[0].second;
  for (std::size_t k = 0; k < n; ++k) {
    while (current + 1 < classes.size() && below < stratum_centre(k, n) * total)
      below += classes[++current].second;
    out[k] = classes[current].first;
  }
  return out;
}

/// Cumulative distribution of ln(diameter) between the cut-offs at equidistant points, not normalised; any
/// median works, however far outside the cut-offs, because only the shape between them counts.
std::vector<double> lognormal_cumulative(const SizeDistribution& sizes, double low, double step,
                                         std::size_t intervals) {
  const auto exponent = [&](double log_diameter) {
    const double deviation = (log_diameter - std::log(sizes.median)) / sizes.sigma;
    return -0.5 * deviation * deviation;
  };
  const double high = low + step * static_cast<double>(intervals);
  const double peak = exponent(std::clamp(std::log(sizes.median), low, high));
  std::vector<double> cumulative(intervals + 1, 0.0);
  for (std::size_t g = 0; g < intervals; ++g)
    cumulative[g + 1] =
        cumulative[g] + std::exp(exponent(low + (static_cast<double>(g) + 0.5) * step) - peak);
  return cumulative;
}

std::vector<double> lognormal_diameters(const SizeDistribution& sizes, std::size_t n) {
  constexpr std::size_t intervals = 4096;
  const double low = std::log(sizes.min), step = (std::log(sizes.max) - low) / static_cast<double>(intervals);
  const auto cumulative = lognormal_cumulative(sizes, low, step, intervals);
  std::vector<double> out(n);
  std::size_t g = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double target = stratum_centre(k, n) * cumulative.back();
    while (g + 1 < intervals && cumulative[g + 1] < target) ++g;
    const double part = (target - cumulative[g]) / (cumulative[g + 1] - cumulative[g]);
    out[k] = std::exp(low + (static_cast<double>(g) + part) * step);
  }
  out.back() = sizes.max;
  if (n > 1) out.front() = sizes.min;
  return out;
}

}  // namespace

std::vector<double> stratified_diameters(const SizeDistribution& sizes, std::size_t n) {
  switch (sizes.kind) {
    case SizeDistribution::Kind::lognormal:
      return lognormal_diameters(sizes, n);
    case SizeDistribution::Kind::uniform:
      return uniform_diameters(sizes, n);
    case SizeDistribution::Kind::list:
      break;
  }
  return listed_diameters(sizes, n);
}

double volume_of_diameters(const std::vector<double>& diameters) {
  double cubes = 0;
  for (const double d : diameters) cubes += d * d * d;
  return std::numbers::pi / 6.0 * cubes;
}

std::size_t count_for_volume(const SizeDistribution& sizes, double volume, std::size_t largest_count) {
  constexpr std::size_t sample = 10000;
  double count =
      volume / volume_of_diameters(stratified_diameters(sizes, sample)) * static_cast<double>(sample);
  // The extremes of a wide distribution depend on the count, so correct it by its own volume a few times.
  constexpr int corrections = 8;
  for (int k = 0;; ++k) {
    if (!(count <= static_cast<double>(largest_count)))
      throw UsageError(
          fmt::format("packing: it would take {:.3g} spheres; at most {} are allowed: choose a smaller "
                      "container or larger spheres",
                      count, largest_count));
    const double n = std::max(1.0, std::round(count));
    if (k == corrections) return static_cast<std::size_t>(n);
    const double corrected =
        n * volume / volume_of_diameters(stratified_diameters(sizes, static_cast<std::size_t>(n)));
    if (std::round(corrected) == n) return static_cast<std::size_t>(n);
    count = corrected;
  }
}

double median_for_volume(SizeDistribution sizes, std::size_t n, double volume) {
  const auto volume_at = [&](double median) {
    sizes.median = median;
    return volume_of_diameters(stratified_diameters(sizes, n));
  };
  double low = sizes.min, high = sizes.max;
  const double least = volume_at(low), most = volume_at(high);
  if (volume < least || volume > most)
    throw UsageError(
        fmt::format("packing: {} spheres cannot fill {:.6g} m^3 with a median between the cut-offs {} and {} "
                    "m (they fill {:.6g} to "
                    "{:.6g} m^3); change the count, sigma or the cut-offs",
                    n, volume, sizes.min, sizes.max, least, most));
  constexpr int halvings = 60;
  for (int k = 0; k < halvings; ++k) {
    const double middle = std::sqrt(low * high);
    (volume_at(middle) < volume ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

}  // namespace superstep
