#pragma once
/// What exponential propagators have in common: all instants of a batch come out of one pass.

#include <span>
#include <vector>

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
  void reset_counts() override {
    batches_ = 0, most_terms_ = 0, inflow_ = bound_ = rounding_ = 0, bounded_ = true;
  }
  void add_counts(Statistics& statistics) const override;

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
  /// Time of the origin [s].
  [[nodiscard]] double now() const noexcept { return t_batch_; }
  /// Time from the origin to the end of the stretch [s].
  [[nodiscard]] double stretch() const noexcept { return instants_.back().t - t_batch_; }
  [[nodiscard]] double span() const noexcept { return span_; }
  /// rms error that one batch, or one stretch where its batches share an origin, may add [K or V].
  [[nodiscard]] double allowed() const noexcept { return allowed_; }
  /// The same in spans, but as if there were no rounding.
  [[nodiscard]] double part_allowed() const noexcept { return part_allowed_; }
  /// Bound of an error's rms by its capacity-weighted rms [-]; largest value, in spans.
  [[nodiscard]] double rms_over_weighted() const noexcept { return rms_over_weighted_; }
  [[nodiscard]] double magnitude() const noexcept { return magnitude_; }
  /// Bound of a vector's rms by its capacity norm, and the capacity norm of a uniform 1.
  [[nodiscard]] double rms_over_norm() const noexcept { return rms_over_weighted_ / norm_of_one_; }
  [[nodiscard]] double norm_of_one() const noexcept { return norm_of_one_; }
  [[nodiscard]] bool stop_requested() const noexcept { return plan_->stop && plan_->stop->load(); }
  /// The capacity inner product.
  [[nodiscard]] double dot(std::span<const double> a, std::span<const double> b) const;
  /// Results of a network in which nothing exchanges anything: values grow by their sources.
  [[nodiscard]] Outcome no_exchange(std::span<Output> outputs);
  /// Of what a whole run may do, the part that is this batch's [-].
  [[nodiscard]] double share_of_run() const noexcept { return share_of_run_; }
  void count_terms(std::size_t terms) noexcept {
    most_terms_ = std::max(most_terms_, static_cast<int>(terms));
  }
  /// Adds to the bound of the run's error, in spans: what the method leaves out, and what is rounded.
  void add_bound(double truncation, double rounding) noexcept {
    bound_ += truncation + rounding;
    rounding_ += rounding;
  }
  /// Bounds of the error that a space has at its instants [K or V].
  struct Bounds {
    double truncation = 0, rounding = 0;
  };
  /// Adds what `now` exceeds `before` by, which becomes `now`; says that there is no bound where it says
  /// nothing.
  void add_growth(const Bounds& now, Bounds& before) noexcept;
  /// Says that there is none.
  void give_up_bound() noexcept { bounded_ = false; }

 private:
  /// Allocates, or refuses the scene.
  virtual void allocate() = 0;
  /// True when every batch of a stretch starts from its beginning; else each from the end of the one before.
  [[nodiscard]] virtual bool keeps_origin() const noexcept { return false; }
  /// The origin is a new one.
  virtual void start_over() {}
  /// Fills states, probes and inflows of `outputs` from `origin()`.
  [[nodiscard]] virtual Outcome propagate(std::span<Output> outputs) = 0;
  [[nodiscard]] Outcome compute_batch(std::size_t first);
  void move_origin();

  double rtol_, part_;
  Rhs* rhs_ = nullptr;
  const Plan* plan_ = nullptr;
  StateVector origin_;
  std::vector<StateVector> states_;  ///< room for those of one batch
  std::span<const Instant> instants_;
  std::vector<Output> outputs_;
  std::span<const double> current_;
  std::size_t batch_begin_ = 0, batch_size_ = 0, recorded_ = 0, reached_ = 0;
  double t_ = 0, t_batch_ = 0, span_ = 0, allowed_ = 0, inflow_before_ = 0, inflow_ = 0;
  double rms_over_weighted_ = 1, norm_of_one_ = 1, magnitude_ = 0, bound_ = 0, rounding_ = 0,
         part_allowed_ = 0;
  double share_of_run_ = 1;
  std::uint64_t batches_ = 0;
  int most_terms_ = 0;
  bool bounded_ = true;
};

}  // namespace superstep
