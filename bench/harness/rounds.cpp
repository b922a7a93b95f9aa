/// Who takes part in a benchmark, in which order, within which limits; what repetitions come to.

#include <algorithm>

#include "bench/harness/harness.hpp"
#include "integrators/registry.hpp"

namespace superstep {

std::vector<std::string> contenders(const Scene& scene, const std::vector<std::string>& asked) {
  std::vector<std::string> specs = asked.empty() ? scene.bench.integrators : asked;
  if (specs.empty()) specs = representatives();
  if (std::find(specs.begin(), specs.end(), scene.bench.baseline) == specs.end())
    specs.push_back(scene.bench.baseline);
  return specs;
}

RunLimits limits_of_reference(const RunLimits& limits) {
  constexpr double longer = 10;  // tight tolerances, twice
  return {.seconds = longer * limits.seconds, .sweeps = 0, .say = limits.say};
}

std::vector<std::size_t> round_order(std::size_t n, std::size_t round) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < n; ++k) order.push_back((k + round) % n);
  return order;
}

Timing summarize(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const std::size_t n = seconds.size();
  return {
      .median = 0.5 * (seconds[(n - 1) / 2] + seconds[n / 2]), .min = seconds.front(), .max = seconds.back()};
}

}  // namespace superstep
