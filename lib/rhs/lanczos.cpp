#include "rhs/lanczos.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace superstep {
namespace {

constexpr int check_every = 5;

/// Deterministic start with a part in every eigenvector: pseudo-random entries of both signs, each made from
/// its own row's number, so that whoever has the row gets the same.
///   Source: the finaliser of SplitMix64, Steele, Lea & Flood (2014), doi:10.1145/2714064.2660195
void fill_start(std::size_t first_row, std::span<double> v) {
  for (std::size_t i = 0; i < v.size(); ++i) {
    std::uint64_t z = (first_row + i + 1) * 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z ^= z >> 31;
    v[i] = static_cast<double>(z >> 11) * 0x1p-53 - 0.5;
  }
}

/// Largest Ritz value of the tridiagonal matrix and the last component of its vector, in a few passes over
/// it: in networks like chains, whose search takes hundreds of products, whole eigenvectors of every space
/// cost ten times what the products do.
///
/// The pivots of x I - T are all > 0 exactly where x is above every eigenvalue. From there Newton's method on
/// their product goes down to the largest one and never below it; halving what is between it and a lower
/// bound helps it along where eigenvalues lie close.
class LargestRitz {
 public:
  LargestRitz(const std::vector<double>& diagonal, const std::vector<double>& off)
      : diagonal_(diagonal), off_(off), pivot_(diagonal.size()) {}

  std::pair<double, double> find() {
    constexpr double close = 1e-13;
    const auto [low_end, high_end] = all_within();
    const double enough = close * std::max(std::abs(low_end), std::abs(high_end));
    double high = high_end;
    double low = *std::max_element(diagonal_.begin(), diagonal_.end());
    for (double step = high - low; step > enough && high > low;) {
      const double slope = log_slope(high);
      if (!(slope > 0)) break;  // closer than rounding tells
      step = 1 / slope;
      high -= step;
      if (const double middle = 0.5 * (low + high); middle < high && step > enough)
        (log_slope(middle) > 0 ? high : low) = middle;
    }
    high += enough;  // the pivots of the vector are those of a value above
    (void)log_slope(high);
    return {high, last_component(high)};
  }

 private:
  /// Where all eigenvalues lie, by Gershgorin's circles.
  [[nodiscard]] std::pair<double, double> all_within() const {
    double low = diagonal_[0], high = low;
    for (std::size_t i = 0; i < diagonal_.size(); ++i) {
      const double beside = (i > 0 ? off_[i - 1] : 0) + (i < off_.size() ? off_[i] : 0);
      low = std::min(low, diagonal_[i] - beside);
      high = std::max(high, diagonal_[i] + beside);
    }
    return {low, high};
  }
  /// Derivative of the logarithm of the characteristic polynomial; 0 where x is not above every eigenvalue.
  double log_slope(double x) {
    double sum = 0, pivot = 0, slope = 0;
    for (std::size_t i = 0; i < diagonal_.size(); ++i) {
      const double quotient = i > 0 ? off_[i - 1] / pivot : 0;
      slope = 1 + quotient * quotient * slope;
      pivot = x - diagonal_[i] - (i > 0 ? off_[i - 1] * quotient : 0);
      if (!(pivot > 0)) return 0;
      pivot_[i] = pivot;
      sum += slope / pivot;
    }
    return sum;
  }
  /// Of the vector of length 1 at x, by elimination from both ends to the row where the least is left, so
  /// that a last component of 1e-30 is found, too. Source: Dhillon & Parlett (2004),
  /// doi:10.1016/j.laa.2003.12.028.
  [[nodiscard]] double last_component(double x) const {
    const std::size_t n = diagonal_.size();
    std::vector<double> upward(n);
    std::size_t twist = n - 1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = n; i-- > 0;) {
      upward[i] = x - diagonal_[i] - (i + 1 < n ? off_[i] * off_[i] / upward[i + 1] : 0);
      const double left = pivot_[i] + upward[i] - (x - diagonal_[i]);
      if (left < least) least = left, twist = i;
    }
    double square = 1, component = 1;
    for (std::size_t i = twist; i-- > 0;) {
      component *= off_[i] / pivot_[i];
      square += component * component;
    }
    component = 1;
    for (std::size_t i = twist; i + 1 < n; ++i) {
      component *= off_[i] / upward[i + 1];
      square += component * component;
    }
    return component / std::sqrt(square);
  }

  const std::vector<double>&diagonal_, &off_;
  std::vector<double> pivot_;
};

void scale(std::vector<double>& v, double factor) {
  for (double& entry : v) entry *= factor;
}

}  // namespace

double SpectralEstimate::safe(double certified) const noexcept {
  if (!(largest > 0)) return certified;
  // Rounded up to a grid: steps that depend on the radius then do not depend on the numbering of the nodes,
  // which changes the estimate in its last digits.
  constexpr double inflation = 1.01, steps_per_octave = 64;
  const double inflated = std::max(inflation * largest, largest + residual);
  return std::min(certified, std::exp2(std::ceil(std::log2(inflated) * steps_per_octave) / steps_per_octave));
}

SpectralEstimate largest_eigenvalue(const Operator& apply, std::span<const double> capacity,
                                    const LanczosLimits& limits) {
  return largest_eigenvalue(apply, capacity, Reduction(capacity.size()), 0, limits);
}

SpectralEstimate largest_eigenvalue(const Operator& apply, std::span<const double> capacity,
                                    const Reduction& reduction, std::size_t first_row,
                                    const LanczosLimits& limits) {
  const std::size_t n = capacity.size();
  const auto dot = [&](const std::vector<double>& a, const std::vector<double>& b) {
    return reduction.sum([&](std::size_t i) { return capacity[i] * a[i] * b[i]; });
  };
  std::vector<double> v(n), previous(n, 0.0), w(n), diagonal, off;
  fill_start(first_row, v);
  SpectralEstimate estimate;
  if (reduction.total() == 0) return estimate;
  scale(v, 1 / std::sqrt(dot(v, v)));
  double beta = 0;
  const int last_product =
      static_cast<int>(std::min(reduction.total(), static_cast<std::size_t>(limits.most)));
  for (int k = 1; k <= last_product; ++k) {
    apply(v, w);
    estimate.products = k;
    const double alpha = dot(v, w);
    for (std::size_t i = 0; i < n; ++i) w[i] -= alpha * v[i] + beta * previous[i];
    diagonal.push_back(alpha);
    beta = std::sqrt(dot(w, w));
    const bool exhausted = !(beta > 1e-14 * std::abs(alpha));  // an invariant subspace: the value is exact
    if (exhausted || k == last_product || (k >= limits.fewest && k % check_every == 0)) {
      const auto [ritz, last] = LargestRitz(diagonal, off).find();
      estimate.largest = ritz;
      estimate.residual = exhausted ? 0 : beta * last;
      if (exhausted || estimate.residual <= limits.tolerance * ritz) break;
    }
    off.push_back(beta);
    scale(w, 1 / beta);
    std::swap(previous, v);
    std::swap(v, w);
  }
  return estimate;
}

SpectralEstimate estimate_spectral_radius(Rhs& rhs, const LanczosLimits& limits) {
  SpectralEstimate out;
  const auto fields = rhs.fields();
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const auto minus_block = [&](std::span<const double> v, std::span<double> product) {
      rhs.block_product(f, v, product);
      for (double& entry : product) entry = -entry;
    };
    const auto capacity = rhs.capacities().subspan(fields[f].offset, fields[f].count);
    const Reduction of_field(std::array{fields[f].count}, fields[f].total(), rhs.reduction().among());
    const auto estimate = largest_eigenvalue(minus_block, capacity, of_field, fields[f].first_row, limits);
    const int products = out.products + estimate.products;
    if (estimate.largest > out.largest) out = estimate;
    out.products = products;
  }
  return out;
}

}  // namespace superstep
