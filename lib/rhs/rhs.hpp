#pragma once
/// The right-hand side that every integrator sees: dy/dt = f(t, y) on the owned (free) entries.

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/time_table.hpp"
#include "parallel/reduction.hpp"
#include "rhs/kernels/sparse_pattern.hpp"
#include "rhs/rhs_facts.hpp"
#include "rhs/stage.hpp"

namespace superstep {

/// What a method may rely on. A method that needs more than a scene offers refuses it.
struct RhsTraits {
  bool linear = false;  ///< f(t, y) = b(t) - A y with constant A
  bool constant_jacobian = false;
  bool symmetric = false;   ///< C J symmetric: the Jacobian is self-adjoint in the capacity inner product
  bool autonomous = false;  ///< f does not depend on t
  bool smooth = true;       ///< f has no bends in the state, as tables of conductivities have
  /// The fields' own diagonal blocks of J are constant and symmetric but for a diagonal part that
  /// `radius_beyond_blocks` bounds, and at most one field acts on the other: the spectrum is that of the
  /// blocks.
  bool constant_blocks = false;
};

/// One field's entries inside the state: offset, offset + stride, ... (count of them). Where processes share
/// a state, each has consecutive rows of every field.
struct FieldView {
  std::string name;  ///< "temperature" or "potential"
  std::string unit;  ///< "K" or "V"
  std::size_t offset = 0, stride = 1, count = 0;
  double origin = 0;                         ///< K or V: entries are differences from it
  std::size_t first_row = 0, elsewhere = 0;  ///< of all rows, the one that comes first here; those not here
  [[nodiscard]] std::size_t total() const noexcept { return count + elsewhere; }
};

/// Work done by a right-hand side since the last reset.
struct RhsCounters {
  std::uint64_t sweeps = 0;            ///< passes over a field's network, fused or not
  std::uint64_t jacobians = 0;         ///< evaluations of Jacobian values
  std::uint64_t potential_solves = 0;  ///< steady potentials solved for
};
[[nodiscard]] inline RhsCounters difference(const RhsCounters& after, const RhsCounters& before) noexcept {
  return {after.sweeps - before.sweeps, after.jacobians - before.jacobians,
          after.potential_solves - before.potential_solves};
}

/// What one table of time does to f: its value times these rates.
struct InputShape {
  const TimeTable* table = nullptr;
  struct Rate {
    std::int32_t entry = 0;
    double rate = 0;  ///< K/s or V/s for a unit of the table
  };
  std::vector<Rate> rates;  ///< to be added up: an entry may be there several times
};

/// Thrown by one of several processes that share a right-hand side, and then by all of them, when it is asked
/// for what only one that has the whole of it can give.
struct NeedsWhole : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class OneWayCoupling;

class Rhs {
 public:
  virtual ~Rhs() = default;

  [[nodiscard]] std::size_t size() const noexcept { return reduction_.size(); }
  [[nodiscard]] const RhsTraits& traits() const noexcept { return traits_; }
  [[nodiscard]] std::span<const FieldView> fields() const noexcept { return fields_; }
  [[nodiscard]] const RhsFacts& facts() const noexcept { return facts_; }
  [[nodiscard]] const Reduction& reduction() const noexcept { return reduction_; }
  [[nodiscard]] const RhsCounters& counters() const noexcept { return *counters_; }
  /// Its own among all right-hand sides of this program's life.
  [[nodiscard]] std::uint64_t identity() const noexcept { return identity_; }

  /// dydt = f(t, y). One sweep.
  void operator()(double t, std::span<const double> y, std::span<double> dydt) {
    stage(t, {.y1 = y.data(), .a = 0, .d = 1}, dydt);
  }
  /// One fused stage. One sweep over the network of every field that is being stepped.
  void stage(double t, const Stage& stage, std::span<double> out) {
    counters_->sweeps += networks_swept_;
    do_stage(t, stage, out);
  }
  /// At most `longest_chain` stages in a row, the same as one by one. On networks beyond the cache they pass
  /// over it together, which spares most of the traffic.
  ///   with_inflow  sets the inflow of every stage, too
  void chain(std::span<ChainedStage> stages, bool with_inflow, ChainObserver* observer = nullptr) {
    counters_->sweeps += networks_swept_ * stages.size();
    do_chain(stages, with_inflow, observer);
  }
  /// The same as `stage` with f(t, y1) replaced by J*y1; only for linear right-hand sides. One sweep.
  void linear_stage(const Stage& stage, std::span<double> out) {
    ++counters_->sweeps;
    do_linear_stage(stage, out);
  }
  /// out = J_ff v, the constant block of one field; v and out [fields()[field].count]. One sweep. Only where
  /// the blocks are constant.
  void block_product(std::size_t field, std::span<const double> v, std::span<double> out) {
    ++counters_->sweeps;
    do_block_product(field, v, out);
  }
  /// A product with an assembled Jacobian is the work of a sweep, too: whoever makes one says so.
  void count_product() noexcept { counters_->sweeps += networks_swept_; }
  /// Values of the Jacobian df/dy at (t, y) on `own_pattern()` [1/s].
  void jacobian(double t, std::span<const double> y, std::span<double> values) {
    ++counters_->jacobians;
    do_jacobian(t, y, values);
  }
  /// Sparsity of the Jacobian; built at the first call, so that methods without matrices never pay for it.
  /// Throws NeedsWhole where processes share it.
  [[nodiscard]] const SparsePattern& pattern() {
    if (reduction_.among()) throw NeedsWhole("it forms a matrix of the whole network");
    return own_pattern();
  }
  /// The same; where processes share it, of the rows and columns that are here.
  [[nodiscard]] const SparsePattern& own_pattern() {
    if (pattern_.column_begin.empty()) pattern_ = build_pattern();
    return pattern_;
  }

  /// Rigorous upper bound of the spectral radius of J at (t, y) [1/s].
  [[nodiscard]] virtual double spectral_bound(double t, std::span<const double> y) = 0;
  /// What the spectral radius may exceed that of the constant blocks by, at (t, y) [1/s].
  [[nodiscard]] virtual double radius_beyond_blocks(double /*t*/, std::span<const double> /*y*/) const {
    return 0;
  }
  /// Weights of the inner product in which J is symmetric [n]: the capacities.
  [[nodiscard]] virtual std::span<const double> capacities() const noexcept = 0;
  /// Net heat entering the temperature field at (t, y) [W], from outside and from Joule heat; charge [A]
  /// where the potential is the only field. The sum of C_i f_i.
  [[nodiscard]] virtual double inflow(double t, std::span<const double> y) = 0;
  /// Derivative of `inflow` along a change v of a linear right-hand side.
  [[nodiscard]] virtual double linear_inflow(std::span<const double> v) const = 0;

  /// What changes in time about a linear f of one field, one shape a table that acts on it: f(t, y) - f(t',
  /// y) is the sum of what their tables changed by times their rates. The tables live as long as f.
  [[nodiscard]] virtual std::vector<InputShape> input_shapes() const { return {}; }

  /// Says which law a state goes beyond, at which node, and the way out; nothing where all hold. A trial
  /// state beyond is to be tried again smaller, an accepted one ends the run. Cheap where no law is limited.
  ///   slack  [K] how far beyond still counts as at the end of the range: what the state may err by
  [[nodiscard]] virtual std::optional<std::string> law_violation(std::span<const double> /*y*/,
                                                                 double /*slack*/ = 0) {
    return std::nullopt;
  }

  /// The two halves of a scene in which one field drives the other through sources alone, or not at all; null
  /// elsewhere.
  [[nodiscard]] virtual OneWayCoupling* one_way() { return nullptr; }

  /// Takes the smooth piece of f between `begin` and `end`, two neighbouring breakpoints [s]: until the next
  /// call every input is the line that it is there, for any t. Without it f is the whole function of time.
  virtual void enter(double /*begin*/, double /*end*/) {}
  /// Back to the whole function of time.
  virtual void leave() {}

  /// How accurate a run needs f to be where a part of it is found approximately [-]; 0 = as the scene states.
  virtual void ask_accuracy(double /*relative*/) {}

 protected:
  ///   among  the processes that share it, null = all of it is here
  Rhs(std::size_t size, RhsTraits traits, std::vector<FieldView> fields, Communicator* among = nullptr);
  Rhs(const Rhs&) = delete;
  Rhs& operator=(const Rhs&) = delete;

  RhsFacts facts_;                    ///< set by the constructors of derived classes
  std::uint64_t networks_swept_ = 1;  ///< by one stage
  void count_into(RhsCounters& counters) noexcept { counters_ = &counters; }
  [[nodiscard]] RhsCounters& mutable_counters() noexcept { return *counters_; }

 private:
  virtual void do_stage(double t, const Stage& stage, std::span<double> out) = 0;
  virtual void do_chain(std::span<ChainedStage> stages, bool with_inflow, ChainObserver* observer);
  virtual void do_linear_stage(const Stage& stage, std::span<double> out) = 0;
  virtual void do_block_product(std::size_t field, std::span<const double> v, std::span<double> out) = 0;
  virtual void do_jacobian(double t, std::span<const double> y, std::span<double> values) = 0;
  [[nodiscard]] virtual SparsePattern build_pattern() = 0;

  Reduction reduction_;
  RhsTraits traits_;
  std::vector<FieldView> fields_;
  RhsCounters own_counters_, *counters_ = &own_counters_;
  SparsePattern pattern_;
  std::uint64_t identity_;
};

}  // namespace superstep
