#pragma once
/// exp(-t A) by Lanczos in the capacity inner product: adapts to the spectrum that the start really excites.
///
/// A first pass builds the tridiagonal matrix T until the residual of its small solution, integrated over
/// time, is below the tolerance: in a contractive network that bounds the error. A second pass repeats the
/// recurrence and adds up the results, so that memory stays at a few vectors.

#include "integrators/detail/exponential/instant_batch.hpp"

namespace superstep {

class LanczosPropagator final : public InstantBatch {
 public:
  using InstantBatch::InstantBatch;

 private:
  void allocate() override;
  [[nodiscard]] Outcome propagate(std::span<Output> outputs) override;

  /// v_{j+1} from v_j and v_{j-1}; extends or repeats alpha_ and beta_. Returns false when the space is
  /// exhausted.
  bool next_vector(std::size_t j);
  void begin_space();
  [[nodiscard]] bool accurate(double elapsed) const;
  [[nodiscard]] double dot(const std::vector<double>& a, const std::vector<double>& b) const;
  [[nodiscard]] double allowed_error() const;
  [[nodiscard]] double precision_of_small_solution(double elapsed) const;

  std::vector<double> v_, previous_, w_;
  double length_ = 0;                 ///< of f(X_0) in the capacity norm
  std::vector<double> alpha_, beta_;  ///< of T: diagonal, and what couples j to j+1
};

/// y(t) and its integral for y' = -T y + e_1, y(0) = 0, T symmetric tridiagonal and positive semidefinite.
struct TridiagonalResponse {
  std::vector<double> value, integral;
};
[[nodiscard]] TridiagonalResponse tridiagonal_response(std::span<const double> alpha,
                                                       std::span<const double> beta, double t,
                                                       double tolerance);

}  // namespace superstep
