#include "audit/oracle/dense_network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace superstep::audit {
namespace {

constexpr Real rounding = std::numeric_limits<Real>::epsilon();

/// One pass over all pairs of columns; the largest cosine between two of them that was seen.
Real rotate_pairs(std::size_t n, std::size_t columns, std::vector<Real>& x) {
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
      const Real cosine = std::abs(ab) / std::sqrt(aa * bb);
      if (!(cosine > rounding)) continue;
      largest = std::max(largest, cosine);
      const Real zeta = (bb - aa) / (2 * ab);
      const Real t = (zeta < 0 ? -1 : 1) / (std::abs(zeta) + std::sqrt(1 + zeta * zeta));
      const Real c = 1 / std::sqrt(1 + t * t), s = c * t;
      for (std::size_t k = 0; k < n; ++k) {
        const Real moved = c * a[k] - s * b[k];
        b[k] = s * a[k] + c * b[k];
        a[k] = moved;
      }
    }
  return largest;
}

}  // namespace

NetworkFactor::NetworkFactor(std::vector<Real> weight, std::vector<Real> outward,
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

std::vector<Real> NetworkFactor::solve(std::vector<Real> right) const {
  for (const auto p : order)
    for (std::size_t i = 0; i < n; ++i)
      if (i != p) right[i] -= lower[i * n + p] * right[p];
  for (std::size_t i = 0; i < n; ++i) right[i] = pivot[i] > 0 ? right[i] / pivot[i] : 0;
  for (auto p = order.rbegin(); p != order.rend(); ++p)
    for (std::size_t i = 0; i < n; ++i)
      if (i != *p) right[*p] -= lower[i * n + *p] * right[i];
  return right;
}

Modes find_modes(const NetworkFactor& factor, const std::vector<Real>& capacity) {
  const std::size_t n = factor.n;
  std::vector<Real> x;  // columns of C^-1/2 L D^1/2
  std::size_t columns = 0;
  for (const auto p : factor.order) {
    if (!(factor.pivot[p] > 0)) continue;
    ++columns;
    for (std::size_t i = 0; i < n; ++i)
      x.push_back(factor.lower[i * n + p] * std::sqrt(factor.pivot[p] / capacity[i]));
  }
  // Quadratic at the end: a dozen passes are plenty, and rounding ends them.
  for (int pass = 0; pass < 40 && rotate_pairs(n, columns, x) > 4 * rounding; ++pass) {
  }
  Modes modes;
  for (std::size_t m = 0; m < columns; ++m) {
    Real square = 0;
    for (std::size_t k = 0; k < n; ++k) square += x[m * n + k] * x[m * n + k];
    modes.rate.push_back(square);
    for (std::size_t k = 0; k < n; ++k) modes.vector.push_back(x[m * n + k] / std::sqrt(square));
  }
  if (columns == n) return modes;
  // A connected network that leads nowhere has one mode that stays: the uniform one.
  Real total = 0;
  for (const Real c : capacity) total += c;
  modes.rate.push_back(0);
  for (const Real c : capacity) modes.vector.push_back(std::sqrt(c / total));
  return modes;
}

Phi phi(Real x) {
  Phi out;
  out.decay = std::exp(-x);
  if (x < 0.25L) {  // series: sum (-x)^k/(k+2)!
    Real term = 0.5L;
    out.two = 0;
    for (int k = 0; k < 20; ++k) {
      out.two += term;
      term *= -x / static_cast<Real>(k + 3);
    }
    out.one = 1 - x * out.two;
    return out;
  }
  out.one = -std::expm1(-x) / x;
  out.two = (1 - out.one) / x;
  return out;
}

}  // namespace superstep::audit
