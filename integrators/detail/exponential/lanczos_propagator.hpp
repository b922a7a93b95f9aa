#pragma once
/// exp(-t A) by Lanczos in the capacity inner product: adapts to the spectrum that the start really excites.
/// For constant inputs.
///
///   y(t) = y_0 + |f_0| V u(t),   u' = e_1 - T u,   A V = V T + beta v_{m+1} e_m^T
///
/// One pass: the basis V is kept, and every output, probe and inflow of a stretch comes out of it. What u
/// leaves of the equation is -|f_0| beta u_m(s) v_{m+1}. A network contracts in the capacity norm, so that
/// the integral of this residual bounds the error, orthogonal or not: see residual_bound.hpp. It is what a
/// run reports; it stops earlier, by an estimate of what the network's damping leaves of the error. Where the
/// basis outgrows its memory the time that it does cover is taken and a new one begins there. Source:
/// Hochbruck & Lubich (1997), doi:10.1137/S0036142995280572.

#include <optional>

#include "integrators/detail/exponential/instant_batch.hpp"
#include "integrators/detail/krylov/lanczos_space.hpp"

namespace superstep {

class LanczosPropagator final : public InstantBatch {
 public:
  ///   memory  that the basis may take [bytes]
  LanczosPropagator(double rtol, double memory, double part = 1)
      : InstantBatch(rtol, part), memory_(memory) {}

 private:
  void allocate() override;
  [[nodiscard]] bool keeps_origin() const noexcept override { return true; }
  void start_over() override;
  [[nodiscard]] Outcome propagate(std::span<Output> outputs) override;

  /// A space of dimension 0 from `start_` at `offset_`.
  void open_space();
  /// rms error after `elapsed` in the present space [K or V]: an upper bound, and what it will be.
  [[nodiscard]] double bound_at(double elapsed) const { return space_->bound_at(elapsed) * rms_over_norm(); }
  [[nodiscard]] double estimate_at(double elapsed) const {
    return space_->estimate_at(elapsed, {}) * space_->rms_over_norm(rms_over_norm());
  }
  [[nodiscard]] double time_covered(double longest) const;
  [[nodiscard]] std::vector<double> significant(std::vector<double> coefficients, double& dropped) const;
  void evaluate(std::span<Output> outputs);
  [[nodiscard]] Outcome grow(double elapsed);
  [[nodiscard]] Outcome restart_at(double covered, double error);

  double memory_;
  std::size_t most_vectors_ = 0;
  LanczosSpace::Recent recent_;
  std::optional<LanczosSpace> space_;
  StateVector start_;          ///< state from which the present space starts
  double offset_ = 0;          ///< its time since the origin [s]
  double start_inflow_ = 0;    ///< since the origin [J or C]
  double rate_of_inflow_ = 0;  ///< at the start of the space
  Bounds reported_;            ///< of its error
  double unspent_ = 0;         ///< of the allowed error [K or V]
  bool open_ = false, covered_ = false;
};

}  // namespace superstep
