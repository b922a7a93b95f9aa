#pragma once
/// Watches a run from outside its arithmetic: growth beyond what the physics allows, and the wish to stop.

#include <optional>
#include <span>
#include <string>

#include "integrators/integrator.hpp"

namespace superstep {

/// A value that leaves the maximum principle's range (initial and fixed values, ambients, widened by what
/// sources can add) by more than ten times the range's own width is growth of errors. Less is no proof: a
/// stable but lightly damped superstep was seen to overshoot by once the width.
class RunGuard {
 public:
  void prepare(const Rhs& rhs, const Plan& plan);
  /// Looks at the whole state; call it at output times and every `stride` steps.
  ///   rhs  of the scene, or of the field that is left of it: its last ones
  [[nodiscard]] Outcome check(double t, std::span<const double> y, const Rhs& rhs) const;
  [[nodiscard]] bool stop_requested() const noexcept {
    return stop_ && stop_->load(std::memory_order_relaxed);
  }
  /// Processes that share a run agree on the wish to stop in their sums; where steps have none, in one of
  /// their own now and then. Call it at every step end.
  void agree(const Rhs& rhs);

  static constexpr unsigned stride = 64;

 private:
  /// What has grown among the rows that are here.
  [[nodiscard]] std::optional<std::string> growth_of(double t, std::span<const double> y,
                                                     const Rhs& rhs) const;

  std::vector<FieldRange> ranges_;
  std::vector<double> source_rate_;  // [fields]
  double t_begin_ = 0;
  std::uint64_t reductions_ = 0;  ///< of the processes, by the last step end
  unsigned silent_ = 0;           ///< step ends since
  const std::atomic<bool>* stop_ = nullptr;
};

/// The outcome of a run that was asked to stop.
[[nodiscard]] Outcome interrupted_at(double t);

/// Number of equal steps of at most `step` that cover `span`; rounding in the quotient does not add a step.
[[nodiscard]] std::uint64_t steps_to_cover(double span, double step) noexcept;

}  // namespace superstep
