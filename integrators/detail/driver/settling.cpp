#include "integrators/detail/driver/settling.hpp"

#include <algorithm>
#include <cmath>

namespace superstep {
namespace {

double rms_distance(const Reduction& reduction, std::span<const double> a, std::span<const double> b) {
  const double sum = reduction.sum([&](std::size_t i) { return (a[i] - b[i]) * (a[i] - b[i]); });
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, reduction.total())));
}

}  // namespace

void Settling::prepare(Rhs& rhs, double tolerance, double span) {
  coupling_ = tolerance > 0 && span > 0 ? rhs.one_way() : nullptr;
  allowed_ = tolerance * span;
  residual_ = 1e-2 * tolerance;
  next_look_ = 0;
  final_.clear();
  if (coupling_ && !coupling_->driver().traits().autonomous) coupling_ = nullptr;
  if (coupling_) seen_.reserve(coupling_->driver().size());
}

bool Settling::is_steady(double t, std::span<const double> y) {
  if (!coupling_ || t < next_look_) return false;
  const Rhs& driver = coupling_->driver();
  const auto now = y.first(driver.size());
  const bool first = next_look_ == 0;
  next_look_ = 1.1 * t;  // where it still moves, a tenth of the time that has gone by is waited
  if (first || !(rms_distance(driver.reduction(), now, seen_) <= allowed_)) {
    seen_.assign(now.begin(), now.end());
    return false;
  }
  if (final_.empty()) final_ = coupling_->steady_driver(residual_);
  if (final_.size() != now.size()) coupling_ = nullptr;  // it goes on for ever
  if (!coupling_) return false;
  return rms_distance(driver.reduction(), now, final_) <= allowed_;
}

}  // namespace superstep
