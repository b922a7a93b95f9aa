#pragma once
/// exp(-t A) by Chebyshev polynomials on [0, rho]: one fused sweep a term, error known beforehand.

#include "integrators/detail/output_batch.hpp"

namespace superstep {

class ChebyshevPropagator final : public BatchPropagator {
 public:
  /// rtol: error at each output time relative to the span of the field, in the capacity-weighted rms norm.
  explicit ChebyshevPropagator(double rtol) : rtol_(rtol) {}

 private:
  void allocate(std::size_t outputs) override;
  [[nodiscard]] Outcome propagate(std::span<Output> outputs) override;
  void collect(std::span<Output> outputs, std::size_t k, std::span<const double> u);
  void add_pair(std::span<Output> outputs, std::size_t k, std::span<const double> u,
                std::span<const double> next);

  double rtol_;
  std::vector<double> u_, next_;
  std::vector<std::vector<double>> coefficients_, integrals_;  ///< one list per output
};

}  // namespace superstep
