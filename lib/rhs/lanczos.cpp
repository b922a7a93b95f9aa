#include "rhs/lanczos.hpp"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
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

/// Largest Ritz value of the tridiagonal matrix and the last component of its vector.
std::pair<double, double> largest_ritz(const std::vector<double>& diagonal, const std::vector<double>& off) {
  const auto k = static_cast<Eigen::Index>(diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  const Eigen::Map<const Eigen::VectorXd> d(diagonal.data(), k), e(off.data(), k - 1);
  solver.computeFromTridiagonal(d, e, Eigen::ComputeEigenvectors);
  return {solver.eigenvalues()(k - 1), solver.eigenvectors()(k - 1, k - 1)};
}

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
      const auto [ritz, last] = largest_ritz(diagonal, off);
      estimate.largest = ritz;
      estimate.residual = exhausted ? 0 : std::abs(beta * last);
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
