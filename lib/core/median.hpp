#pragma once
/// The median of measurements.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace superstep {

/// The middle value, or the mean of the middle two. Not empty. O(n).
[[nodiscard]] inline double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace superstep
