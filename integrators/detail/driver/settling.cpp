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

void Settling::prepare(Rhs& rhs, double tolerance, double driver_span, double driven_span, double t_end) {
  coupling_ = tolerance > 0 && driver_span > 0 ? rhs.one_way() : nullptr;
  allowed_ = tolerance * driver_span;
  allowed_driven_ = tolerance * driven_span;
  t_end_ = t_end;
  residual_ = 1e-2 * tolerance;
  next_look_ = 0;
  final_.clear();
  if (coupling_ && !coupling_->driver().traits().autonomous) coupling_ = nullptr;
  if (!coupling_) return;
  seen_.reserve(coupling_->driver().size());
  for (auto* v : {&rate_, &final_rate_}) v->resize(coupling_->driven().size());
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
  if (!coupling_ || !(rms_distance(driver.reduction(), now, final_) <= allowed_)) return false;
  if (heats_alike(t, now)) return true;
  // It still moves, or its end is not known well enough where it is small.
  constexpr double finer = 1e-3, finest = 1e-14;
  if (residual_ > finest) {
    residual_ = std::max(finest, finer * residual_);
    final_.clear();
  }
  return false;
}

/// Whether the heat of now and that of the end do the same to the driven field in the time that is left. A
/// part of low potential, or of little capacity, may be far from its end while the span of the others hides
/// it.
bool Settling::heats_alike(double t, std::span<const double> now) {
  coupling_->rate(t, now, rate_);
  coupling_->rate(t, final_, final_rate_);
  const Reduction& driven = coupling_->driven().reduction();
  return rms_distance(driven, rate_, final_rate_) * (t_end_ - t) <= allowed_driven_;
}

}  // namespace superstep
