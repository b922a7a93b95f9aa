#pragma once
/// The only loop over time, as integrators/driver.hpp offers it.
///
/// Between two breakpoints of the inputs f is smooth: the loop lands on every breakpoint and takes f piece by
/// piece. Steps are accepted by the method's own error estimate against the run's tolerance; their limits are
/// those of the states at which they are used. What has become steady is not stepped on.

#include <memory>
#include <optional>
#include <string>

#include "integrators/detail/driver/error_budget.hpp"
#include "integrators/detail/driver/probe_recorder.hpp"
#include "integrators/detail/driver/run_guard.hpp"
#include "integrators/detail/driver/settling.hpp"
#include "integrators/detail/driver/step_controller.hpp"
#include "integrators/integrator.hpp"

namespace superstep {

class Driver {
 public:
  explicit Driver(std::unique_ptr<Method> method) : method_(std::move(method)) {}
  ~Driver();
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  void prepare(Rhs& rhs, const Plan& plan);
  void start(double t, std::span<const double> y);
  [[nodiscard]] Outcome advance(double t_out);
  [[nodiscard]] std::size_t size() const noexcept { return whole_ ? whole_->size() : 0; }
  [[nodiscard]] double time() const noexcept { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept;
  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }
  [[nodiscard]] double rtol() const { return method_->rtol(); }
  [[nodiscard]] std::string choice() const { return method_->choice(); }
  [[nodiscard]] std::optional<double> settled_at() const noexcept { return settled_at_; }

 private:
  void prepare_settling();
  void prepare_method(Rhs& rhs);
  void find_spans_once(double t, std::span<const double> y);
  [[nodiscard]] std::vector<double> allowed_errors(const Rhs& rhs) const;

  // Pieces of time between breakpoints.
  void begin_run_of(Rhs& rhs);
  void enter_piece(bool smooth);
  void take_piece_of_inputs();
  [[nodiscard]] bool goes_on_smoothly(const Breakpoint& point) const;
  [[nodiscard]] double piece_end() const noexcept;

  // One-step methods.
  [[nodiscard]] Outcome step_to(double target);
  [[nodiscard]] Outcome take_own_steps(double target);
  [[nodiscard]] Outcome take_controlled_steps(double target);
  /// Length of the next step of controlled size.
  [[nodiscard]] double landing(double step, double limit, double target) const;
  [[nodiscard]] double first_step(double largest);
  /// Makes the trial and looks at its end; empty = it can be accepted as far as stability and laws go.
  struct Look {
    Trial trial;
    bool stable = true, lawful = true;
    double limit = 0;  ///< longest stable step at the end of the trial [s]
  };
  [[nodiscard]] Look try_step(const Step& step);
  void accept(const Step& step);
  [[nodiscard]] Outcome after_step();
  [[nodiscard]] Outcome cannot_shrink(double h, const Look& look) const;

  // Propagators.
  [[nodiscard]] Outcome propagate_to(double target);
  void list_instants();

  [[nodiscard]] double law_slack() const noexcept;
  /// Where steps have just been turned back by a law, that is why they are short.
  [[nodiscard]] Outcome too_short(std::string why) const;
  [[nodiscard]] Outcome look_at(std::span<const double> y);
  /// Not ok when the run must not go on: somebody wants it to stop, or its work is beyond what it may be.
  [[nodiscard]] Outcome may_go_on();
  void settle_if_steady();
  void unsettle();
  void complete_state();
  void note_extremes();
  void publish();
  void update_statistics();

  std::unique_ptr<Method> method_;
  OneStepMethod* stepper_ = nullptr;
  Propagator* propagator_ = nullptr;
  Rhs *whole_ = nullptr, *rhs_ = nullptr;  ///< of the scene, and what is left of it once a field has settled
  Plan plan_;
  Task task_;
  RunGuard guard_;
  ProbeRecorder recorder_;
  Settling settling_;
  ErrorBudget budget_;
  StepController controller_{1};
  StateVector state_, next_, slope_, turned_, full_;
  std::vector<double> ends_, driven_rate_;
  std::uint64_t sweeps_before_ = 0;  // of the right-hand side, when the run began
  std::vector<Propagator::Instant> instants_;
  std::size_t next_instant_ = 0;
  std::size_t next_breakpoint_ = 0;
  double t_ = 0, piece_begin_ = 0;
  bool spans_are_known_ = false;
  // Own steps: equal ones from `from` to `target`.
  struct {
    double from = 0, target = 0, step = 0;
    std::uint64_t count = 0, done = 0;
  } lattice_;
  double step_ = 0;  ///< planned controlled step, 0 = not chosen yet [s]
  double cap_ = 0;   ///< own steps are not longer than this, after a step had to be repeated [s]
  unsigned since_look_ = 0;
  int lawless_ = 0;                 // trial steps that went beyond the range of a law
  std::string lawless_why_;         // of the last one
  std::uint64_t lawless_step_ = 0;  // steps that had been accepted by then
  std::optional<double> settled_at_;
  Statistics counted_, statistics_;  ///< by the driver; with what the method counts
};

}  // namespace superstep
