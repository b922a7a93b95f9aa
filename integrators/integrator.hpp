#pragma once
/// What a method is: a file that holds the arithmetic of a step, or a propagator over a smooth stretch of
/// time.
///
/// The loop over time is not a method's business: `driver.hpp` has it, once. It lands on output times and on
/// breakpoints of the inputs, accepts and rejects steps, keeps the tolerance, watches growth, settling and
/// the wish to stop. A scene that a method cannot treat is refused in `prepare`; what goes wrong later is an
/// Outcome, not an exception.

#include <atomic>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/state_vector.hpp"
#include "integrators/probe_history.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

enum class Status { ok, inaccurate, unstable, failed, refused, timeout, interrupted };
[[nodiscard]] const char* status_name(Status status) noexcept;

/// How a run, or a part of it, ended; `reason` says why, with numbers and advice, unless it is ok.
struct Outcome {
  Status status = Status::ok;
  std::string reason;
  [[nodiscard]] bool ok() const noexcept { return status == Status::ok; }
};

/// Thrown by `prepare` when a method cannot treat a scene; `what()` says which property is missing.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a run is asked for, known before it starts.
struct Plan {
  double t_begin = 0;
  std::vector<double> output_times;  ///< ascending, > t_begin [s]
  std::vector<FieldRange> ranges;    ///< one per field: initial and fixed values
  /// One per field: largest minus smallest value over all nodes and the whole run [K or V], what tolerances
  /// refer to. Empty: the driver finds them when it starts (see spans.hpp).
  std::vector<double> spans;
  std::vector<std::size_t> probes;  ///< entries whose values are recorded at step ends
  bool full_states = true;          ///< false: nobody reads `state()`, probes are enough
  bool track_inflow = false;        ///< propagators integrate `Rhs::inflow`
  double settle_tolerance = 0;      ///< of the potential's span; 0 = a driving field is stepped to the end
  std::vector<FieldRange>* extremes = nullptr;  ///< [fields] gain the values at step ends; may be null
  ProbeHistory* history = nullptr;              ///< where step ends are recorded; may be null
  const std::atomic<bool>* stop = nullptr;      ///< set from outside: stop at the next step end
  std::uint64_t most_sweeps = 0;           ///< of the right-hand side, looked at at step ends; 0 = no limit
  std::atomic<double>* reached = nullptr;  ///< gains the time at step ends, for one who watches; may be null
};

/// Work and facts of one run since `start`.
struct Statistics {
  std::uint64_t steps = 0;  ///< accepted steps (supersteps for STS)
  std::uint64_t rejected = 0;
  std::uint64_t factorizations = 0;
  std::uint64_t solves = 0;    ///< linear solves
  std::uint64_t landings = 0;  ///< breakpoints at which the history of a method was void
  int max_stages = 0;          ///< most sweeps in one step
  double inflow = 0;           ///< heat [J] or charge [C] entered since start, when tracked
  double time_per_sweep = 0;   ///< time that one sweep of a full step covers [s]; 0 = no fixed ratio
  /// Bound of the error over the span (rms); 0 = the method has none. What the method leaves out is proven.
  double error_bound = 0;
  double rounding_bound = 0;  ///< the part of it that is rounding, which is modelled
  double error_estimate = 0;  ///< sum of the estimated local errors over the tolerance [-]; 0 = no estimate
};

/// What a method is told before a run, or before the rest of one.
struct Task {
  double t_begin = 0, t_end = 0;  ///< s
  /// [fields] what an error of 1 means: the run's tolerance, rtol times the span or, where rounding is more,
  /// a hundred roundings of the largest value [K or V].
  std::vector<double> allowed;
  std::vector<double> spans;     ///< [fields] K or V
  double rounding = 0;           ///< of the largest value, in units of `allowed` [-], at most 0.01
  const Plan* plan = nullptr;    ///< of the run
  std::size_t propagations = 1;  ///< stretches and batches of outputs among which a run is divided
};

class OneStepMethod;
class Propagator;

class Method {
 public:
  virtual ~Method() = default;
  /// Allocates and analyses; everything that allocates happens here. `rhs` outlives its use. Throws Refused.
  virtual void prepare(Rhs& rhs, const Task& task) = 0;
  /// Error that the user allows at output times, relative to the span; 0 = the method takes no tolerance.
  [[nodiscard]] virtual double rtol() const { return 0; }
  /// One of the two, once prepared.
  [[nodiscard]] virtual OneStepMethod* one_step() { return nullptr; }
  [[nodiscard]] virtual Propagator* propagator() { return nullptr; }
  /// What a method chose by itself and why, once prepared and started; empty when it had nothing to choose.
  [[nodiscard]] virtual std::string choice() const { return {}; }
  /// Adds what the method itself counted since the last reset.
  virtual void add_counts(Statistics& /*statistics*/) const {}
  virtual void reset_counts() {}
};

/// Steps that a one-step method is asked for: from t over the given ends. More than one end is asked for only
/// where nothing can be rejected and the method said that it takes chains.
struct Step {
  double t = 0;                  ///< s
  std::span<const double> ends;  ///< ascending, > t [s]
  [[nodiscard]] double h() const noexcept { return ends.front() - t; }
};

/// What became of a trial step.
struct Trial {
  bool solved = true;       ///< false: the step cannot be done at this size; a smaller one may
  double error = 0;         ///< estimated local error in units of `Task::allowed`; 0 = there is no estimate
  double factor = 0;        ///< next step over this one as the method itself wants it; 0 = no wish
  std::string reason = {};  ///< why it was not solved
};

class OneStepMethod : public Method {
 public:
  [[nodiscard]] OneStepMethod* one_step() final { return this; }

  /// How the driver divides time.
  enum class Pace {
    multiples,  ///< the method's own step again and again, the last one shortened
    equal,      ///< equal steps, none longer than the method's own
    error,      ///< as long as the estimated error allows
    method,     ///< as `Trial::factor` says
  };
  [[nodiscard]] virtual Pace pace() const = 0;
  /// Step that the method wants to begin with at (t, y) [s]; infinity = no limit. Of pace multiples and
  /// equal: its own step.
  [[nodiscard]] virtual double own_step(double t, std::span<const double> y) = 0;
  /// True when stability depends on the state: what it allows is then looked at before and after every step.
  [[nodiscard]] virtual bool stability_varies() const { return false; }
  /// Longest step from (t, y) that can be made stable [s].
  [[nodiscard]] virtual double longest_step(double /*t*/, std::span<const double> /*y*/) {
    return std::numeric_limits<double>::infinity();
  }
  /// Longest step that the trial just made could have had if it were to be stable at (t, y), where it ends
  /// [s].
  [[nodiscard]] virtual double stable_step(double /*t*/, std::span<const double> /*y*/) {
    return std::numeric_limits<double>::infinity();
  }
  /// A step about as long as h that wastes no work, at most `longest` [s].
  [[nodiscard]] virtual double convenient(double h, double /*longest*/) const { return h; }
  /// Change of the step over which a new one has to be to be worth it [-]; 1 = any.
  [[nodiscard]] virtual double worth_changing() const { return 1; }
  /// Order of the error that is estimated: it falls with h^(order+1).
  [[nodiscard]] virtual int order() const { return 1; }
  /// Local error that a step may have, as part of the run's tolerance, so that what is delivered is
  /// proportional to rtol.
  [[nodiscard]] virtual double share() const { return 1; }
  /// Steps that may be asked for at once.
  [[nodiscard]] virtual std::size_t longest_chain_of_steps() const { return 1; }

  /// f(t, y) where the method has it at hand, else empty.
  [[nodiscard]] virtual std::span<const double> slope() const { return {}; }

  /// From here on: at (t, y) something is new.
  ///   smooth  only by so little that the history of the method still serves
  virtual void restart(double t, std::span<const double> y, bool smooth) = 0;
  /// Computes the state at the last of `step.ends` from `state` into `next`; with more than one end `state`
  /// may be written over, else it stays as it is.
  [[nodiscard]] virtual Trial attempt(const Step& step, StateVector& state, StateVector& next) = 0;
  /// The trial just made was accepted and `state` is its result.
  virtual void accept(const Step& /*step*/, std::span<const double> /*state*/) {}
};

/// A method with its own way through time: it is given smooth stretches.
class Propagator : public Method {
 public:
  [[nodiscard]] Propagator* propagator() final { return this; }

  /// True when the method takes inputs with all their breakpoints: one stretch then lasts to the end of the
  /// run, and f is the whole function of time.
  [[nodiscard]] virtual bool takes_breakpoints() const noexcept { return false; }

  /// An instant inside a stretch at which something is wanted.
  struct Instant {
    double t = 0;
    bool state = true;  ///< the whole state, not only the probes
  };
  /// f is smooth from t to `end` and nothing beyond may be looked at. `instants` end there, or where the run
  /// does.
  ///   smooth  the stretch before goes on so nearly the same that its history still serves
  virtual void begin(double t, double end, std::span<const double> y, std::span<const Instant> instants,
                     bool smooth) = 0;
  /// Goes on towards instant number k of the stretch, the next one not reached; may stop on the way, so that
  /// the driver can look at the run.
  [[nodiscard]] virtual Outcome advance(std::size_t k) = 0;
  [[nodiscard]] virtual double time() const noexcept = 0;
  /// State at `time()`, wherever the driver may look: at instants with a state and at stops on the way.
  [[nodiscard]] virtual std::span<const double> state() const noexcept = 0;
  /// True when every `advance` ends at a step end of the propagator's own, with a state to look at.
  [[nodiscard]] virtual bool stops_on_the_way() const noexcept { return false; }
  /// Hands what the probes were since the last call to the history.
  virtual void record(ProbeHistory& history) = 0;
};

}  // namespace superstep
