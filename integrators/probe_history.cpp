#include "integrators/probe_history.hpp"

#include <algorithm>

namespace superstep {

void ProbeHistory::clear() noexcept {
  time_.clear();
  coefficient_.clear();
  order_.clear();
  begin_.clear();
}

void ProbeHistory::reserve(std::size_t steps) {
  time_.reserve(steps);
  order_.reserve(steps);
  begin_.reserve(steps);
  coefficient_.reserve(steps * probes_);
}

void ProbeHistory::append(double t, std::span<const double> values) {
  append(t, values, 0);
}

void ProbeHistory::append(double t, std::span<const double> taylor, int order) {
  time_.push_back(t);
  order_.push_back(order);
  begin_.push_back(coefficient_.size());
  coefficient_.insert(coefficient_.end(), taylor.begin(), taylor.end());
}

double ProbeHistory::value(std::size_t step, std::size_t probe) const noexcept {
  return coefficient_[begin_[step] + probe];
}

double ProbeHistory::at(double t, std::size_t probe) const noexcept {
  const auto found = std::lower_bound(time_.begin(), time_.end(), t);
  if (found == time_.end()) return value(size() - 1, probe);
  const auto step = static_cast<std::size_t>(found - time_.begin());
  const double s = t - time_[step];
  if (order_[step] > 0) {
    double sum = 0;
    for (int k = order_[step]; k >= 0; --k)
      sum = sum * s + coefficient_[begin_[step] + static_cast<std::size_t>(k) * probes_ + probe];
    return sum;
  }
  if (step == 0 || s == 0) return value(step, probe);
  const double width = time_[step] - time_[step - 1];
  return value(step, probe) + s / width * (value(step, probe) - value(step - 1, probe));
}

ProbeHistory::Data ProbeHistory::data() const {
  return {time_, order_, coefficient_};
}

ProbeHistory ProbeHistory::from(std::size_t probes, const Data& data) {
  ProbeHistory history(probes);
  std::size_t begin = 0;
  for (std::size_t step = 0; step < data.time.size(); ++step) {
    const std::size_t count = (static_cast<std::size_t>(data.order[step]) + 1) * probes;
    history.append(data.time[step], std::span(data.coefficient).subspan(begin, count), data.order[step]);
    begin += count;
  }
  return history;
}

}  // namespace superstep
