#include "core/time_table.hpp"

#include <algorithm>

namespace superstep {

double TimeTable::at(double t) const noexcept {
  const auto after = std::upper_bound(time.begin(), time.end(), t);
  if (after == time.begin()) return value.front();
  if (after == time.end()) return value.back();
  const auto k = static_cast<std::size_t>(after - time.begin());
  const double part = (t - time[k - 1]) / (time[k] - time[k - 1]);
  return value[k - 1] + part * (value[k] - value[k - 1]);
}

double TimeTable::lowest() const noexcept {
  return *std::min_element(value.begin(), value.end());
}

double TimeTable::highest() const noexcept {
  return *std::max_element(value.begin(), value.end());
}

}  // namespace superstep
