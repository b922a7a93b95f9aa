#pragma once
/// What exponential propagators have in common: all output times of a batch come out of one pass.
///
/// `advance` must be called with the plan's output times, one after the other. With `full_states` off only
/// probes are formed; all output times then share one pass.

#include <span>
#include <vector>

#include "core/state_vector.hpp"
#include "integrators/detail/run_guard.hpp"
#include "integrators/detail/spectral_radius.hpp"
#include "integrators/integrator.hpp"

namespace superstep {

/// Base of propagators that compute several output times at once and hand them out one by one.
class BatchPropagator : public Integrator {
 public:
  void prepare(Rhs& rhs, const Plan& plan) final;
  void start(double t, std::span<const double> y) final { start_at(t, y, 0); }
  /// The same in the middle of the plan: the output times before number `next_output` are past.
  void start_at(double t, std::span<const double> y, std::size_t next_output);
  Outcome advance(double t_out) final;
  [[nodiscard]] double time() const noexcept final { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept final { return *current_; }
  [[nodiscard]] const Statistics& statistics() const noexcept final { return statistics_; }

 protected:
  /// One output of the batch: time since the batch began, and where its results go.
  struct Output {
    double elapsed = 0;          ///< s
    bool full = true;            ///< the whole state is wanted, not only the probes
    StateVector state;           ///< [n], when full
    std::vector<double> probes;  ///< [probes], always
    double inflow = 0;           ///< J or C entered since the batch began, when tracked
  };

  [[nodiscard]] Rhs& rhs() const noexcept { return *rhs_; }
  [[nodiscard]] const Plan& plan() const noexcept { return plan_; }
  [[nodiscard]] std::span<const double> origin() const noexcept { return *origin_; }
  [[nodiscard]] double radius() const noexcept { return radius_; }
  [[nodiscard]] bool stop_requested() const noexcept { return guard_.stop_requested(t_); }
  [[nodiscard]] double now() const noexcept { return t_batch_; }
  /// Results of a network in which nothing exchanges anything: values grow by their sources.
  [[nodiscard]] Outcome no_exchange(std::span<Output> outputs);
  Statistics statistics_;

 private:
  /// Allocates for at most `outputs` outputs at once.
  virtual void allocate(std::size_t outputs) = 0;
  /// Fills states, probes and inflows of `outputs` from `origin()`.
  [[nodiscard]] virtual Outcome propagate(std::span<Output> outputs) = 0;

  [[nodiscard]] Outcome compute_batch();

  Rhs* rhs_ = nullptr;
  Plan plan_;
  RunGuard guard_;
  StateVector first_state_;
  std::vector<Output> outputs_;
  const StateVector* origin_ = nullptr;
  const StateVector* current_ = nullptr;
  std::size_t next_output_ = 0, batch_begin_ = 0, batch_size_ = 0;
  double t_ = 0, t_batch_ = 0, radius_ = 0, inflow_before_ = 0;
};

}  // namespace superstep
