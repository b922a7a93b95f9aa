#include "core/round_marks.hpp"

#include <algorithm>
#include <cmath>

namespace superstep {
namespace {

constexpr double wanted = 5;           // marks, about
constexpr double slack = 1e-9;         // of a step: an end that misses a mark by a rounding has it
constexpr double of_rounding = 1e-12;  // of the larger end
constexpr double smallest = 1e-300, largest = 1e300;  // beyond, differences are no numbers any more

}  // namespace

AxisRange room_for_marks(double low, double high) noexcept {
  low = std::clamp(low, -largest, largest);
  high = std::clamp(high, -largest, largest);
  const double size = std::max(std::abs(low), std::abs(high));
  if (high - low > std::max(of_rounding * size, smallest)) return {low, high};
  const double margin = size > smallest ? 0.1 * size : 1;
  return {low - margin, high + margin};
}

double round_step(double span) noexcept {
  const double raw = span / wanted, power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power * (1 + slack)) return factor * power;
  return 10 * power;
}

std::vector<double> round_marks(double low, double high, double step) {
  const double first = std::ceil(low / step - slack), last = std::floor(high / step + slack);
  std::vector<double> marks;
  // Counted from the first one: far from zero, one more to a large number may be the same number.
  for (double k = 0; k <= last - first; ++k) marks.push_back((first + k) * step + 0.0);  // never minus zero
  return marks;
}

}  // namespace superstep
