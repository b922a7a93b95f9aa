#include "integrators/detail/driver/settling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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
  if (final_.empty()) find_final_state(t);
  if (final_.size() != now.size()) coupling_ = nullptr;  // it goes on for ever
  if (!coupling_ || !(rms_distance(driver.reduction(), now, final_) <= allowed_)) return false;
  const double before = std::exchange(difference_, heat_still_to_differ(t, now));
  if (difference_ <= allowed_driven_) return true;
  // What moves comes nearer from look to look; else its end is not known well enough where it is small.
  constexpr double nearer = 0.8, finer = 1e-3, finest = 1e-14;
  if (difference_ > nearer * before && residual_ > finest) {
    residual_ = std::max(finest, finer * residual_);
    final_.clear();
  }
  return false;
}

void Settling::find_final_state(double t) {
  final_ = coupling_->steady_driver(residual_);
  difference_ = std::numeric_limits<double>::infinity();
  if (final_.size() == coupling_->driver().size()) coupling_->rate(t, final_, final_rate_);
}

/// By how much the heat of now and that of the end let the driven field differ in the time that is left [K].
/// A part of low potential, or of little capacity, may be far from its end while the span of the others hides
/// it.
double Settling::heat_still_to_differ(double t, std::span<const double> now) {
  coupling_->rate(t, now, rate_);
  return rms_distance(coupling_->driven().reduction(), rate_, final_rate_) * (t_end_ - t);
}

}  // namespace superstep
