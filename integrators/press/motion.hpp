#pragma once
/// Runs the press: steps, restarts, phases, history. How a step is taken is the stepper's business.

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "dynamics/moving_network.hpp"
#include "dynamics/stepping.hpp"
#include "integrators/integrator.hpp"
#include "integrators/press/energy.hpp"
#include "integrators/press/history.hpp"
#include "integrators/press/switches.hpp"
#include "integrators/press/thermal_bridge.hpp"

namespace superstep::dynamics {

/// What became of an attempt at a step.
struct Attempt {
  bool converged = false;
  int iterations = 0;
  double factor = 1;          ///< that the stepper wants the step size multiplied with
  std::int32_t culprit = -1;  ///< particle that kept the step from converging; -1 = unknown
  std::string why;            ///< what about it
  Outcome failure;            ///< not ok: no smaller step would help
};

/// Takes steps. `state` is untouched until the attempt converged.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Called once at the state that steps start from; the network is placed and settled there.
  virtual void begin(const State& state) = 0;
  /// Tries a step of h [s] within `phase`. When it converged, `state` holds its end and the network is placed
  /// there.
  [[nodiscard]] virtual Attempt attempt(State& state, const Phase& phase, double h) = 0;
  /// Longest step that the method may take from the state of `begin` [s].
  [[nodiscard]] virtual double limit() const noexcept = 0;
  /// Normal force on the upper wall at the state of `begin` [N].
  [[nodiscard]] virtual double wall_force() const noexcept = 0;
  /// The integrator of the temperatures; null when the stepper takes them itself.
  [[nodiscard]] virtual const ThermalBridge* bridge() const noexcept = 0;

  const std::atomic<bool>* stop = nullptr;  ///< set from outside: an attempt may end in an interruption
};

/// How far a particle may go in one step, in the smallest radius: two that fly at each other are then seen to
/// overlap, at any speed, before they could be through.
inline constexpr double farthest_in_a_step = 0.5;

[[nodiscard]] std::unique_ptr<Stepper> make_stepper(const SteppingSettings& settings, MovingNetwork& network);

class Motion {
 public:
  /// Model and particles must outlive it. Throws InputError for zero particles and InputError or UsageError
  /// for settings out of range.
  Motion(const Model& model, const Particles& particles, const SteppingSettings& settings);

  /// Starts at `state`: bonds form, electrified walls act. Throws NumericalError where no current is found.
  void start(State state);
  /// Goes on from a stored state exactly as if it had never been stored.
  ///   next_step [s]  the step size that was to be tried next
  void resume(State state, double next_step, std::vector<HistoryRow> history);

  /// Integrates up to t_out [s], exactly. Phases end exactly at steps. After a failure the state and the
  /// history are those of the last accepted step.
  [[nodiscard]] Outcome advance(double t_out);

  [[nodiscard]] const State& state() const noexcept { return state_; }
  [[nodiscard]] double next_step() const noexcept { return step_; }
  [[nodiscard]] const std::vector<HistoryRow>& history() const noexcept { return history_; }
  [[nodiscard]] const MovingNetwork& network() const noexcept { return network_; }
  /// Particles that carried current in the last step.
  [[nodiscard]] std::size_t connected_in_step() const noexcept { return connected_; }
  [[nodiscard]] std::uint64_t rejected() const noexcept { return rejected_; }
  [[nodiscard]] std::uint64_t iterations() const noexcept { return iterations_; }
  [[nodiscard]] const ThermalBridge* bridge() const noexcept { return stepper_->bridge(); }

  /// Called after each accepted step, before bonds, electrodes and current change: the network is placed at
  /// the step's end and h [s] is its size.
  std::function<void(const MovingNetwork& network, double h)> observe_step;
  /// Called when everything about a step is done: `state`, `history` and `next_step` make a checkpoint.
  std::function<void()> after_step;
  /// Set from outside: stop at the next step end, or, before the step, inside what takes its temperatures.
  const std::atomic<bool>* stop = nullptr;

 private:
  [[nodiscard]] Outcome stopped() const;
  [[nodiscard]] Outcome take_step(double t_out);
  [[nodiscard]] Outcome undone(const Phase& phase, std::size_t rows, const std::string& why);
  [[nodiscard]] double travel_limit() const;
  [[nodiscard]] Attempt land(const Phase& phase, double& h, bool& landed);
  [[nodiscard]] std::size_t landings_lately(double h) const;
  void accept(const Phase& phase, double h, const Attempt& attempt, std::int64_t rejections, bool landed);
  [[nodiscard]] bool correct_heat(double h, double& heat_added);
  [[nodiscard]] Outcome check() const;
  [[nodiscard]] Outcome held_down(double longest) const;
  [[nodiscard]] Outcome collapsed(double h, const Attempt& attempt) const;
  void record_temperatures(HistoryRow& row) const;
  void record(const Phase& phase, double h, std::int64_t iterations, std::int64_t rejections);

  const Model& model_;
  const Particles& particles_;
  SteppingSettings settings_;
  MovingNetwork network_;
  std::unique_ptr<Stepper> stepper_;
  State state_;
  double step_ = 0;
  std::uint64_t rejected_ = 0, iterations_ = 0;
  std::size_t connected_ = 0;
  bool steady_ = false, locates_ = false;
  double smallest_radius_ = 0;
  Powers powers_;                   // where the step at hand begins
  State before_;                    // of the step at hand
  std::vector<double> heat_begin_;  // [W]
  std::vector<char> carrying_begin_;
  std::vector<HistoryRow> history_;
};

}  // namespace superstep::dynamics
