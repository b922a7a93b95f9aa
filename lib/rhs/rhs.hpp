#pragma once
/// The right-hand side that every integrator sees: dy/dt = f(t, y) on the owned (free) entries.

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "core/reduction.hpp"

namespace superstep {

/// What a method may rely on. A method that needs more than a scene offers refuses it.
struct RhsTraits {
  bool linear = false;  ///< f(t, y) = b(t) - A y with constant A
  bool constant_jacobian = false;
  bool symmetric = false;   ///< C J symmetric: the Jacobian is self-adjoint in the capacity inner product
  bool autonomous = false;  ///< f does not depend on t
};

/// One field's entries inside the state: offset, offset + stride, ... (count of them).
struct FieldView {
  std::string name;  ///< "temperature" or "potential"
  std::string unit;  ///< "K" or "V"
  std::size_t offset = 0, stride = 1, count = 0;
};

/// Sparsity of the Jacobian in compressed columns, rows ascending; the diagonal is always present.
struct SparsePattern {
  std::vector<std::int64_t> column_begin;  ///< [n+1]
  std::vector<std::int64_t> row;           ///< [nnz]
  std::vector<std::int64_t> diagonal;      ///< [n] position of (i,i) in `row`
};

/// One stage of a three-term method, done in a single pass over the network:
///   out = a*y1 + b*y2 + c*y0 + d*f(t, y1) + e*f0
/// Terms with a null vector do not exist. `out` may be y2 but not y1.
struct Stage {
  const double* y1 = nullptr;
  double a = 1, d = 0;
  const double* y2 = nullptr;
  double b = 0;
  const double* y0 = nullptr;
  double c = 0;
  const double* f0 = nullptr;
  double e = 0;
};

/// Work done by a right-hand side since the last reset.
struct RhsCounters {
  std::uint64_t sweeps = 0;     ///< passes over the network, fused or not
  std::uint64_t jacobians = 0;  ///< evaluations of Jacobian values
};

class Rhs {
 public:
  virtual ~Rhs() = default;

  [[nodiscard]] std::size_t size() const noexcept { return reduction_.size(); }
  [[nodiscard]] const RhsTraits& traits() const noexcept { return traits_; }
  [[nodiscard]] std::span<const FieldView> fields() const noexcept { return fields_; }
  /// Changes when conductances (values) or the graph (pattern) change; factorizations and estimates stand
  /// while equal.
  [[nodiscard]] std::uint64_t values_version() const noexcept { return values_version_; }
  [[nodiscard]] std::uint64_t pattern_version() const noexcept { return pattern_version_; }
  [[nodiscard]] const Reduction& reduction() const noexcept { return reduction_; }
  [[nodiscard]] const RhsCounters& counters() const noexcept { return counters_; }

  /// dydt = f(t, y). One sweep.
  void operator()(double t, std::span<const double> y, std::span<double> dydt) {
    stage(t, {.y1 = y.data(), .a = 0, .d = 1}, dydt);
  }
  /// One fused stage. One sweep.
  void stage(double t, const Stage& stage, std::span<double> out) {
    ++counters_.sweeps;
    do_stage(t, stage, out);
  }
  /// The same with f(t, y1) replaced by J*y1; only for linear right-hand sides. One sweep.
  void linear_stage(const Stage& stage, std::span<double> out) {
    ++counters_.sweeps;
    do_linear_stage(stage, out);
  }
  /// Values of the Jacobian df/dy at (t, y) on `pattern()` [1/s].
  void jacobian(double t, std::span<const double> y, std::span<double> values) {
    ++counters_.jacobians;
    do_jacobian(t, y, values);
  }
  /// Sparsity of the Jacobian; built at the first call, so that methods without matrices never pay for it.
  [[nodiscard]] const SparsePattern& pattern() {
    if (pattern_.column_begin.empty()) pattern_ = build_pattern();
    return pattern_;
  }

  /// Rigorous upper bound of the spectral radius of J near (t, y) [1/s].
  [[nodiscard]] virtual double spectral_bound(double t, std::span<const double> y) const = 0;
  /// Pairwise critical step with particle contributions only, the one that the source paper's alpha refers to
  /// [s].
  [[nodiscard]] virtual double pair_step_without_interface() const = 0;
  /// Weights of the inner product in which J is symmetric [n]: the capacities.
  [[nodiscard]] virtual std::span<const double> capacities() const noexcept = 0;
  /// Net heat (or charge) entering through fixed nodes and sources at (t, y) [W or A]: sum of C_i f_i.
  [[nodiscard]] virtual double inflow(double t, std::span<const double> y) const = 0;
  /// Derivative of `inflow` along a change v of a linear right-hand side.
  [[nodiscard]] virtual double linear_inflow(std::span<const double> v) const = 0;
  /// Largest |rate| that sources alone can cause [K/s or V/s]: how fast the maximum principle's range may
  /// widen.
  [[nodiscard]] virtual double source_rate() const = 0;

 protected:
  Rhs(std::size_t size, RhsTraits traits, std::vector<FieldView> fields)
      : reduction_(size), traits_(traits), fields_(std::move(fields)) {}
  Rhs(const Rhs&) = delete;
  Rhs& operator=(const Rhs&) = delete;

  std::uint64_t values_version_ = 1, pattern_version_ = 1;

 private:
  virtual void do_stage(double t, const Stage& stage, std::span<double> out) = 0;
  virtual void do_linear_stage(const Stage& stage, std::span<double> out) = 0;
  virtual void do_jacobian(double t, std::span<const double> y, std::span<double> values) = 0;
  [[nodiscard]] virtual SparsePattern build_pattern() const = 0;

  Reduction reduction_;
  RhsTraits traits_;
  std::vector<FieldView> fields_;
  RhsCounters counters_;
  SparsePattern pattern_;
};

}  // namespace superstep
