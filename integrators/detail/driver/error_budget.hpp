#pragma once
/// The tolerance of a run, shared out among its steps.

#include <algorithm>
#include <cstddef>

namespace superstep {

/// In a contractive network the errors of all steps together bound the error of the run, in units of its
/// tolerance. Most runs spend less than they are given, because early errors decay; where steps add up, what
/// is left is divided by the time that is left.
class ErrorBudget {
 public:
  ///   pieces  between breakpoints: where inputs repeat, every piece errs anew, and nothing need decay
  void restart(std::size_t pieces) noexcept {
    constexpr double few = 20;
    spent_ = 0;
    smallest_part_ = smallest_part * std::min(1.0, few / static_cast<double>(pieces));
  }

  /// Error that a step of length h may have.
  ///   share      what the method asks for;  remaining  time to the end of the run, h included [same unit]
  [[nodiscard]] double allowed(double share, double h, double remaining) const noexcept {
    const double left = std::max(0.0, whole - spent_);
    if (left >= 0.5 * whole) return std::min(share, 0.25 * whole);
    const double part = remaining > 0 ? std::min(1.0, h / remaining) : 1.0;
    return std::clamp(left * part, smallest_part_ * share, share);
  }
  void spend(double error) noexcept { spent_ += error; }
  [[nodiscard]] double spent() const noexcept { return spent_; }

 private:
  static constexpr double whole = 4;  // estimates, of which some part decays
  static constexpr double smallest_part = 0.02;
  double spent_ = 0, smallest_part_ = smallest_part;
};

}  // namespace superstep
