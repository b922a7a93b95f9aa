#pragma once
/// exp(-t A) by a rational Krylov space: powers of (I + gamma A)^-1, one factorization a pole gamma.
///
///   y(t) = y_0 + (t phi_1(-t A)/gamma + I - exp(-t A)) p,   p = gamma (I + gamma A)^-1 f_0
///
/// p is what an implicit Euler step would add, within the span however stiff the network, where f_0 is not;
/// the function of A is bounded, too. The space is as good for any spectrum, and one pole near a tenth of the
/// time serves instants two decades apart. The error of a dimension is judged by what the last two vectors
/// changed; what is reported is the bound of `rational_error`, and how far solutions are from those of the
/// exact matrix, which their corrections tell. Source: van den Eshof & Hochbruck (2006),
/// doi:10.1137/040605461; Moret & Novati (2004), doi:10.1023/B:BITN.0000046805.27551.3b; the start from p is
/// our own.

#include <memory>

#include "integrators/detail/exponential/instant_batch.hpp"
#include "integrators/detail/implicit/shifted_solver.hpp"
#include "integrators/detail/krylov/rational_projection.hpp"

namespace superstep {

class ShiftInvertPropagator final : public InstantBatch {
 public:
  using InstantBatch::InstantBatch;
  /// Instants at most so far apart share a pole.
  static constexpr double widest = 100;
  void add_counts(Statistics& statistics) const override;
  void reset_counts() override;

 private:
  void allocate() override;
  [[nodiscard]] bool keeps_origin() const noexcept override { return true; }
  void start_over() override {
    shortest_ = longest_ = 0;
    reported_ = {};
  }
  [[nodiscard]] Outcome propagate(std::span<Output> outputs) override;

  /// Those at the front that one pole serves; opens its space.
  [[nodiscard]] std::span<Output> serve(std::span<Output> outputs);
  [[nodiscard]] bool open_space();
  /// out = (I + gamma A)^-1 v.
  [[nodiscard]] bool solve(std::span<const double> v, StateVector& out);
  [[nodiscard]] bool find_first_step();
  [[nodiscard]] bool add_vector();
  [[nodiscard]] Outcome grow(std::span<const Output> outputs);
  /// rms of what the last vectors changed at these instants.
  [[nodiscard]] double last_change(std::span<const Output> outputs) const;
  [[nodiscard]] double rms_of(const std::vector<double>& coefficients) const;
  void evaluate(std::span<Output> outputs);
  /// Of the error at these instants, which the space covers.
  void report_bound(std::span<const Output> outputs);

  std::unique_ptr<ShiftedSolver> solver_;
  RationalProjection projection_;
  double shortest_ = 0, longest_ = 0;  ///< instants that the pole serves [s]; 0 = there is no space
  double length_ = 0;                  ///< of p in the capacity norm
  double beyond_ = 0;                  ///< of the last image, the part that leads out of the space [-]
  double error_of_start_ = 0;          ///< of p, in the capacity norm
  double error_of_solutions_ = 0;      ///< the same of images of unit vectors [-]
  Bounds reported_;                    ///< since the origin
  bool refines_ = false, exhausted_ = false;
  std::vector<StateVector> basis_;  ///< orthonormal, one more than the dimension
  StateVector work_, correction_;
};

}  // namespace superstep
