#pragma once
/// The contract of every time integrator.
///
///   prepare(rhs, plan)   allocates and analyses; everything that allocates happens here
///   start(t, y)          sets the state; may be called again to run anew with the same preparation
///   advance(t_out)       integrates up to t_out, exactly; called once per output time, in ascending order
///
/// Step size, history, spectral estimates and factorizations live on from one `advance` to the next while the
/// versions of the right-hand side stand. A numerical failure is an Outcome, not an exception; a scene that a
/// method cannot treat is refused in `prepare`.

#include <atomic>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "integrators/probe_history.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

enum class Status { ok, unstable, failed, refused, interrupted };
[[nodiscard]] const char* status_name(Status status) noexcept;

/// How an `advance` ended; `reason` says why, with numbers and advice, unless it is ok.
struct Outcome {
  Status status = Status::ok;
  std::string reason;
  [[nodiscard]] bool ok() const noexcept { return status == Status::ok; }
};

/// Thrown by `prepare` when a method cannot treat a scene; `what()` says which property is missing.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Range of a field's values: initial, fixed, and (while a run goes on) computed so far.
struct FieldRange {
  double low = 0, high = 0;
  [[nodiscard]] double span() const noexcept { return high - low; }
};

/// What a run is asked for, known before it starts.
struct Plan {
  double t_begin = 0;
  std::vector<double> output_times;         ///< ascending, > t_begin [s]
  std::vector<FieldRange> ranges;           ///< one per field: initial and fixed values
  std::vector<std::size_t> probes;          ///< entries whose values are recorded at step ends
  bool full_states = true;                  ///< false: nobody reads `state()`, probes are enough
  bool track_inflow = false;                ///< integrate `Rhs::inflow` with the method's own quadrature
  ProbeHistory* history = nullptr;          ///< where step ends are recorded; may be null
  const std::atomic<bool>* stop = nullptr;  ///< set from outside: stop at the next step end
  std::atomic<double>* reached = nullptr;   ///< gains the time at step ends, for one who watches; may be null
};

/// Work and facts of one run since `start`.
struct Statistics {
  std::uint64_t steps = 0;  ///< accepted steps (supersteps for STS)
  std::uint64_t rejected = 0;
  std::uint64_t factorizations = 0;
  std::uint64_t solves = 0;   ///< linear solves
  int max_stages = 0;         ///< most sweeps in one step
  double inflow = 0;          ///< heat [J] or charge [C] entered since start, when the plan tracks it
  double time_per_sweep = 0;  ///< time that one sweep of a full step covers [s]; 0 = no fixed ratio
};

class Integrator {
 public:
  virtual ~Integrator() = default;
  /// Throws Refused. `rhs` must outlive the integrator.
  virtual void prepare(Rhs& rhs, const Plan& plan) = 0;
  virtual void start(double t, std::span<const double> y) = 0;
  [[nodiscard]] virtual Outcome advance(double t_out) = 0;
  [[nodiscard]] virtual double time() const noexcept = 0;
  [[nodiscard]] virtual std::span<const double> state() const noexcept = 0;
  [[nodiscard]] virtual const Statistics& statistics() const noexcept = 0;
  /// What a method chose by itself and why, once prepared and started; empty when it had nothing to choose.
  [[nodiscard]] virtual std::string choice() const { return {}; }
};

}  // namespace superstep
