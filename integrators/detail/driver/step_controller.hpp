#pragma once
/// Step size from error estimates, for any one-step method.

#include <algorithm>
#include <cmath>

namespace superstep {

/// Proportional-integral control of Watts and Gustafsson, as in RKC.
/// Source: Sommeijer, Shampine & Verwer (1998), doi:10.1016/S0377-0427(97)00219-7, section 2.3.
class StepController {
 public:
  /// `order` = order of the method: the error falls with h^(order+1).
  explicit StepController(int order) : exponent_(1.0 / (order + 1)) {}

  void restart() noexcept { error_before_ = 0; }

  /// Step after an accepted one of size h with weighted error err (<= 1).
  [[nodiscard]] double after_acceptance(double h, double err) noexcept {
    double factor = largest;
    if (err > 0) {
      factor = safety / std::pow(err, exponent_);
      if (error_before_ > 0) {
        const double memory = h / step_before_ * std::pow(error_before_ / err, exponent_);
        factor = std::min(factor * memory, factor * largest);
      }
    }
    error_before_ = std::max(err, smallest_error);
    step_before_ = h;
    return h * std::clamp(factor, smallest, largest);
  }
  /// Step to try after a rejected one of size h with error err (> 1 or not finite).
  [[nodiscard]] double after_rejection(double h, double err) const noexcept {
    if (!std::isfinite(err)) return smallest * h;
    return h * std::clamp(safety / std::pow(err, exponent_), smallest, 0.9);
  }

 private:
  static constexpr double safety = 0.8, smallest = 0.1, largest = 10, smallest_error = 1e-10;
  double exponent_;
  double error_before_ = 0, step_before_ = 0;
};

}  // namespace superstep
