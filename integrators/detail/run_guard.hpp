#pragma once
/// Watches a run from outside its arithmetic: growth beyond what the physics allows, and the wish to stop.

#include <span>

#include "integrators/integrator.hpp"

namespace superstep {

/// A value that leaves the maximum principle's range (initial and fixed values, widened by what sources can
/// add) by more than ten times the range's own width is growth of errors. Less is no proof: a stable but
/// lightly damped superstep was seen to overshoot by once the width.
class RunGuard {
 public:
  void prepare(const Rhs& rhs, const Plan& plan);
  /// Looks at the whole state; call it at output times and every `stride` steps.
  [[nodiscard]] Outcome check(double t, std::span<const double> y) const;
  /// Asked at step ends: tells whoever watches that `t` is reached.
  [[nodiscard]] bool stop_requested(double t) const noexcept {
    if (reached_) reached_->store(t, std::memory_order_relaxed);
    return stop_ && stop_->load(std::memory_order_relaxed);
  }

  static constexpr unsigned stride = 64;

 private:
  const Rhs* rhs_ = nullptr;
  std::vector<FieldRange> ranges_;
  std::vector<double> source_rate_;  // [fields]
  double t_begin_ = 0;
  const std::atomic<bool>* stop_ = nullptr;
  std::atomic<double>* reached_ = nullptr;
};

/// The outcome of a run that was asked to stop.
[[nodiscard]] Outcome interrupted_at(double t);

/// Number of equal steps of at most `step` that cover `span`; rounding in the quotient does not add a step.
[[nodiscard]] std::uint64_t steps_to_cover(double span, double step) noexcept;

/// Values of the plan's probes at step ends, handed to its history.
class ProbeRecorder final : public ChainObserver {
 public:
  void prepare(const Plan& plan);
  [[nodiscard]] bool wanted() const noexcept { return history_ != nullptr; }
  void record(double t, std::span<const double> y);

  /// Where the stages of a chain are steps: watches it, ...
  [[nodiscard]] ChainObserver& follow(std::span<const ChainedStage> chain) noexcept;
  /// ... and hands over what the probes were at the end of stage k.
  void record_followed(double t, std::size_t k);

 private:
  void entries_done(std::size_t stage, std::size_t first, std::size_t last) override;

  std::vector<std::size_t> probes_;
  std::vector<double> values_;  ///< [longest_chain][probes]
  std::span<const ChainedStage> chain_;
  ProbeHistory* history_ = nullptr;
};

}  // namespace superstep
