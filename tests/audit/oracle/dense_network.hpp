#pragma once
/// Dense linear algebra of one network in extended precision, without cancellation: conductances are only
/// ever added, multiplied and divided, so that modes that are ten decades apart keep their digits.
///
/// `Real` is long double, or a number of more digits: its functions are found beside it.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace superstep::audit {

/// K = L D L^T of conductances between n nodes and from each of them to the outside.
/// Source: elimination with kept row sums, Grassmann, Taksar & Heyman (1985), Oper. Res. 33, 1107.
template <class Real>
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
template <class Real>
struct Modes {
  std::vector<Real> rate;    ///< [n] 1/s, >= 0; exactly 0 for what nothing drains
  std::vector<Real> vector;  ///< [n*n] mode m is vector[m*n .. m*n + n-1]
};

/// e^-x, phi_1(-x) = (1 - e^-x)/x and phi_2(-x) = (1 - phi_1(-x))/x; x >= 0.
template <class Real>
struct Phi {
  Real decay = 1, one = 1, two = Real(1) / 2;
};

/// One pass over all pairs of columns; the largest cosine between two of them that was seen.
template <class Real>
Real rotate_pairs(std::size_t n, std::size_t columns, std::vector<Real>& x) {
  using std::abs, std::sqrt;
  Real largest = 0;
  for (std::size_t p = 0; p < columns; ++p)
    for (std::size_t q = p + 1; q < columns; ++q) {
      Real *a = &x[p * n], *b = &x[q * n];
      Real aa = 0, bb = 0, ab = 0;
      for (std::size_t k = 0; k < n; ++k) {
        aa += a[k] * a[k];
        bb += b[k] * b[k];
        ab += a[k] * b[k];
      }
      const Real cosine = abs(ab) / sqrt(aa * bb);
      if (!(cosine > std::numeric_limits<Real>::epsilon())) continue;
      largest = std::max(largest, cosine);
      const Real zeta = (bb - aa) / (2 * ab);
      const Real t = (zeta < 0 ? -1 : 1) / (abs(zeta) + sqrt(1 + zeta * zeta));
      const Real c = 1 / sqrt(1 + t * t), s = c * t;
      for (std::size_t k = 0; k < n; ++k) {
        const Real moved = c * a[k] - s * b[k];
        b[k] = s * a[k] + c * b[k];
        a[k] = moved;
      }
    }
  return largest;
}

template <class Real>
NetworkFactor<Real>::NetworkFactor(std::vector<Real> weight, std::vector<Real> outward,
                                   const std::vector<Real>& capacity)
    : n(outward.size()), lower(n * n, 0), pivot(n, 0) {
  std::vector<char> done(n, 0);
  for (std::size_t i = 0; i < n; ++i) weight[i * n + i] = 0;
  const auto row_sum = [&](std::size_t i) {
    Real sum = outward[i];
    for (std::size_t j = 0; j < n; ++j) sum += done[j] ? 0 : weight[i * n + j];
    return sum;
  };
  for (std::size_t step = 0; step < n; ++step) {
    std::size_t p = n;
    Real fastest = -1;
    for (std::size_t i = 0; i < n; ++i) {
      if (done[i]) continue;
      const Real rate = row_sum(i) / capacity[i];
      if (rate > fastest) {
        fastest = rate;
        p = i;
      }
    }
    pivot[p] = row_sum(p);
    done[p] = 1;
    order.push_back(p);
    lower[p * n + p] = 1;
    if (!(pivot[p] > 0)) continue;
    for (std::size_t i = 0; i < n; ++i) {
      const Real part = weight[i * n + p] / pivot[p];
      if (done[i] || part == 0) continue;
      lower[i * n + p] = -part;
      outward[i] += part * outward[p];
      for (std::size_t j = 0; j < n; ++j)
        if (!done[j] && j != i) weight[i * n + j] += part * weight[p * n + j];
    }
  }
}

template <class Real>
std::vector<Real> NetworkFactor<Real>::solve(std::vector<Real> right) const {
  for (const auto p : order)
    for (std::size_t i = 0; i < n; ++i)
      if (i != p) right[i] -= lower[i * n + p] * right[p];
  for (std::size_t i = 0; i < n; ++i) right[i] = pivot[i] > 0 ? right[i] / pivot[i] : 0;
  for (auto p = order.rbegin(); p != order.rend(); ++p)
    for (std::size_t i = 0; i < n; ++i)
      if (i != *p) right[*p] -= lower[i * n + *p] * right[i];
  return right;
}

/// By one-sided rotations of the factor, which finds small rates to full relative accuracy.
/// Source: Demmel & Veselic (1992), SIAM J. Matrix Anal. Appl. 13, 1204.
template <class Real>
[[nodiscard]] Modes<Real> find_modes(const NetworkFactor<Real>& factor, const std::vector<Real>& capacity) {
  using std::sqrt;
  constexpr int most_passes = 40;  // quadratic at the end: a dozen are plenty, and rounding ends them
  const std::size_t n = factor.n;
  std::vector<Real> x;  // columns of C^-1/2 L D^1/2
  std::size_t columns = 0;
  for (const auto p : factor.order) {
    if (!(factor.pivot[p] > 0)) continue;
    ++columns;
    for (std::size_t i = 0; i < n; ++i)
      x.push_back(factor.lower[i * n + p] * sqrt(factor.pivot[p] / capacity[i]));
  }
  const Real rounding = std::numeric_limits<Real>::epsilon();
  for (int pass = 0; pass < most_passes && rotate_pairs(n, columns, x) > 4 * rounding; ++pass) {
  }
  Modes<Real> modes;
  for (std::size_t m = 0; m < columns; ++m) {
    Real square = 0;
    for (std::size_t k = 0; k < n; ++k) square += x[m * n + k] * x[m * n + k];
    modes.rate.push_back(square);
    for (std::size_t k = 0; k < n; ++k) modes.vector.push_back(x[m * n + k] / sqrt(square));
  }
  if (columns == n) return modes;
  // A connected network that leads nowhere has one mode that stays: the uniform one.
  Real total = 0;
  for (const Real& c : capacity) total += c;
  modes.rate.push_back(0);
  for (const Real& c : capacity) modes.vector.push_back(sqrt(c / total));
  return modes;
}

template <class Real>
[[nodiscard]] Phi<Real> phi(Real x) {
  using std::exp, std::expm1;
  Phi<Real> out;
  out.decay = exp(Real(-x));
  if (x < Real(0.25)) {  // series: sum (-x)^k/(k+2)!
    Real term = Real(1) / 2;
    out.two = 0;
    for (int k = 0;
         term > std::numeric_limits<Real>::epsilon() / 8 || -term > std::numeric_limits<Real>::epsilon() / 8;
         ++k) {
      out.two += term;
      term *= -x / (k + 3);
    }
    out.one = 1 - x * out.two;
    return out;
  }
  out.one = -expm1(Real(-x)) / x;
  out.two = (1 - out.one) / x;
  return out;
}

}  // namespace superstep::audit
