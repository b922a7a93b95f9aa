#pragma once
/// What exponential propagators have in common: all instants of a batch come out of one pass.

#include <span>
#include <vector>

#include "integrators/detail/explicit/spectral_radius.hpp"
#include "integrators/integrator.hpp"

namespace superstep {

/// Base of propagators of one linear field that compute several instants at once and hand them out one by
/// one.
class InstantBatch : public Propagator {
 public:
  ///   part  of the tolerance that this propagator may use
  explicit InstantBatch(double rtol, double part = 1) : rtol_(rtol), part_(part) {}
  void prepare(Rhs& rhs, const Task& task) final;
  [[nodiscard]] double rtol() const final { return rtol_; }
  void begin(double t, double end, std::span<const double> y, std::span<const Instant> instants,
             bool smooth) final;
  [[nodiscard]] Outcome advance(std::size_t k) final;
  [[nodiscard]] double time() const noexcept final { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept final { return current_; }
  void record(ProbeHistory& history) final;
  void reset_counts() final { passes_ = 0, most_terms_ = 0, inflow_ = rounding_ = 0; }
  void add_counts(Statistics& statistics) const final;

 protected:
  /// One instant of the batch: time since the batch began, and where its results go.
  struct Output {
    double elapsed = 0;          ///< s
    std::span<double> state;     ///< [n], or empty where only probes are wanted
    std::vector<double> probes;  ///< [probes], always
    double inflow = 0;           ///< J or C entered since the batch began, when tracked
  };

  [[nodiscard]] Rhs& rhs() const noexcept { return *rhs_; }
  [[nodiscard]] const Plan& plan() const noexcept { return *plan_; }
  [[nodiscard]] std::span<const double> origin() const noexcept { return origin_; }
  [[nodiscard]] double radius() const noexcept { return radius_; }
  [[nodiscard]] double now() const noexcept { return t_batch_; }
  [[nodiscard]] double span() const noexcept { return span_; }
  /// Part of the span that one batch may err by.
  [[nodiscard]] double tolerance() const noexcept { return tolerance_; }
  [[nodiscard]] bool stop_requested() const noexcept { return plan_->stop && plan_->stop->load(); }
  /// Results of a network in which nothing exchanges anything: values grow by their sources.
  [[nodiscard]] Outcome no_exchange(std::span<Output> outputs);
  /// Of what a whole run may do, the part that is this batch's [-].
  [[nodiscard]] double share_of_run() const noexcept { return share_of_run_; }
  /// Largest value of the field in spans.
  [[nodiscard]] double magnitude() const noexcept { return magnitude_; }
  void count_terms(std::size_t terms) noexcept {
    most_terms_ = std::max(most_terms_, static_cast<int>(terms));
  }
  /// Adds what roundings of a batch may amount to, in spans.
  void count_rounding(double rounding) noexcept { rounding_ += rounding; }

 private:
  /// Allocates, or refuses the scene.
  virtual void allocate() = 0;
  /// Fills states, probes and inflows of `outputs` from `origin()`.
  [[nodiscard]] virtual Outcome propagate(std::span<Output> outputs) = 0;
  [[nodiscard]] Outcome compute_batch(std::size_t first);

  double rtol_, part_;
  Rhs* rhs_ = nullptr;
  const Plan* plan_ = nullptr;
  StateVector origin_;
  std::vector<StateVector> states_;  ///< room for those of one batch
  std::span<const Instant> instants_;
  std::vector<Output> outputs_;
  std::span<const double> current_;
  std::size_t batch_begin_ = 0, batch_size_ = 0, recorded_ = 0, reached_ = 0;
  double t_ = 0, t_batch_ = 0, radius_ = 0, span_ = 0, tolerance_ = 0, inflow_before_ = 0, inflow_ = 0;
  double rms_over_weighted_ = 1, magnitude_ = 0;  ///< bound of one norm by the other [-]; of values, in spans
  double rounding_ = 0;                           ///< in spans
  double share_of_run_ = 1;
  std::uint64_t passes_ = 0;
  int most_terms_ = 0;
};

}  // namespace superstep
