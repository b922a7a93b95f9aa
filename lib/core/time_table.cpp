#include "core/time_table.hpp"

#include <algorithm>

namespace superstep {
namespace {

/// Value at t between the instants k-1 and k, which must differ.
double between(const TimeTable& table, std::size_t k, double t) noexcept {
  const double part = (t - table.time[k - 1]) / (table.time[k] - table.time[k - 1]);
  return table.value[k - 1] + part * (table.value[k] - table.value[k - 1]);
}

/// Index of the first instant after t.
std::size_t next_after(const TimeTable& table, double t) noexcept {
  return static_cast<std::size_t>(std::upper_bound(table.time.begin(), table.time.end(), t) -
                                  table.time.begin());
}

}  // namespace

double TimeTable::at(double t) const noexcept {
  const auto k = next_after(*this, t);
  if (k == 0) return value.front();
  if (k == time.size()) return value.back();
  return between(*this, k, t);
}

double TimeTable::before(double t) const noexcept {
  const auto k = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
  if (k == 0) return value.front();
  if (k == time.size()) return value.back();
  return time[k] == t ? value[k] : between(*this, k, t);
}

double TimeTable::integral(double t0, double t1) const noexcept {
  if (t1 < t0) return -integral(t1, t0);
  double sum = 0, from = t0, left = at(t0);
  for (auto k = next_after(*this, t0); k < time.size() && time[k] < t1; ++k) {
    sum += 0.5 * (left + value[k]) * (time[k] - from);
    from = time[k];
    left = value[k];
  }
  return sum + 0.5 * (left + before(t1)) * (t1 - from);
}

std::pair<double, double> TimeTable::range(double t0, double t1) const noexcept {
  std::pair out(at(t0), at(t0));
  const auto take = [&out](double v) { out = {std::min(out.first, v), std::max(out.second, v)}; };
  for (auto k = next_after(*this, t0); k < time.size() && time[k] <= t1; ++k) take(value[k]);
  take(at(t1));
  return out;
}

TimeTable::Line TimeTable::line(double begin, double end) const noexcept {
  // The middle lies in the right interval even where a knot and `begin` differ by rounding.
  const double middle = begin + 0.5 * (end - begin);
  const auto after = std::upper_bound(time.begin(), time.end(), middle);
  if (after == time.begin()) return {value.front(), 0};
  if (after == time.end()) return {value.back(), 0};
  const auto k = static_cast<std::size_t>(after - time.begin());
  const double slope = (value[k] - value[k - 1]) / (time[k] - time[k - 1]);
  return {value[k - 1] + slope * (begin - time[k - 1]), slope};
}

double TimeTable::lowest() const noexcept {
  return *std::min_element(value.begin(), value.end());
}

double TimeTable::highest() const noexcept {
  return *std::max_element(value.begin(), value.end());
}

}  // namespace superstep
