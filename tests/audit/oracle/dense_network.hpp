#pragma once
/// Dense linear algebra of one network in extended precision, without cancellation: conductances are only
/// ever added, multiplied and divided, so that modes that are ten decades apart keep their digits.

#include <vector>

namespace superstep::audit {

using Real = long double;

/// K = L D L^T of conductances between n nodes and from each of them to the outside.
/// Source: elimination with kept row sums, Grassmann, Taksar & Heyman (1985), Oper. Res. 33, 1107.
class NetworkFactor {
 public:
  ///   weight [n*n]  conductances between nodes, symmetric, the diagonal is ignored;  outward [n] to the
  ///   outside capacity [n]  decides the order of elimination: fast nodes first
  NetworkFactor(std::vector<Real> weight, std::vector<Real> outward, const std::vector<Real>& capacity);
  /// K x = right. Where nothing leads outside, K is singular and the last node in the order gets 0.
  [[nodiscard]] std::vector<Real> solve(std::vector<Real> right) const;

  std::size_t n = 0;
  std::vector<std::size_t> order;  ///< of elimination
  std::vector<Real> lower;         ///< [n*n] row i, column = node that was eliminated
  std::vector<Real> pivot;         ///< [n] by node
};

/// Eigenvalues and orthonormal eigenvectors of C^-1/2 K C^-1/2.
struct Modes {
  std::vector<Real> rate;    ///< [n] 1/s, >= 0; exactly 0 for what nothing drains
  std::vector<Real> vector;  ///< [n*n] mode m is vector[m*n .. m*n + n-1]
};
/// By one-sided rotations of the factor, which finds small rates to full relative accuracy.
/// Source: Demmel & Veselic (1992), SIAM J. Matrix Anal. Appl. 13, 1204.
[[nodiscard]] Modes find_modes(const NetworkFactor& factor, const std::vector<Real>& capacity);

/// e^-x, phi_1(-x) = (1 - e^-x)/x and phi_2(-x) = (1 - phi_1(-x))/x; x >= 0.
struct Phi {
  Real decay = 1, one = 1, two = 0.5L;
};
[[nodiscard]] Phi phi(Real x);

}  // namespace superstep::audit
