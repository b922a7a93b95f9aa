#pragma once
/// exp(-t A) by Chebyshev polynomials on [0, rho]: one fused sweep a term, error known beforehand.

#include "integrators/detail/explicit/spectral_radius.hpp"
#include "integrators/detail/exponential/chebyshev_exponential.hpp"
#include "integrators/detail/exponential/instant_batch.hpp"

namespace superstep {

class ChebyshevPropagator final : public InstantBatch, private ChainObserver {
 public:
  /// rtol: error at each output time relative to the span of the field, in the capacity-weighted rms norm.
  using InstantBatch::InstantBatch;

 private:
  void allocate() override;
  [[nodiscard]] Outcome propagate(std::span<Output> outputs) override;
  [[nodiscard]] double rounding_of_terms(double size, const ExpansionScale& scale) const;
  [[nodiscard]] Outcome expand_state();
  [[nodiscard]] Outcome expand_change();
  /// Time obeys the recurrence as an entry with rate 1 would: of U_k, since the batch began [s].
  [[nodiscard]] double time_of(std::size_t k) const noexcept {
    return 2 * static_cast<double>(k) * static_cast<double>(k) / radius_;
  }
  void entries_done(std::size_t stage, std::size_t first, std::size_t last) override;
  void add_pair(std::size_t k, const double* u, const double* next, std::size_t first, std::size_t last);
  void add_probes(std::size_t k, const double* u, std::size_t first, std::size_t last);
  void add_inflow(std::size_t k, double inflow);

  StateVector u_, next_;
  double radius_ = 0;                ///< 1/s
  double tolerance_ = 0;             ///< of one batch, in spans, capacity-weighted
  StateVector rate_, turn_, drive_;  ///< of the origin: f, its slope in time, f at the time of a term
  std::vector<std::vector<double>> coefficients_, integrals_;  ///< one list per output
  // Of the pass under way:
  std::span<Output> outputs_;
  std::span<const ChainedStage> chain_;
  std::size_t terms_ = 0, chain_begin_ = 0;  ///< number of the first U_k that the chain makes
};

}  // namespace superstep
