#include "integrators/detail/krylov/krylov_space.hpp"

#include <algorithm>
#include <cmath>

#include "integrators/detail/krylov/arnoldi_kernels.hpp"

namespace superstep {

void KrylovSpace::prepare(const Rhs& rhs, const ErrorNorm& norm, ScaledJacobian& jacobian, std::size_t most,
                          std::size_t depth) {
  reduction_ = &rhs.reduction();
  norm_ = &norm;
  jacobian_ = &jacobian;
  most_ = most;
  depth_ = std::min(depth, most);
  basis_.clear();
  basis_.reserve(most + 1);
  part_in_norm_.assign(most + 1, -1.0);
  matrix_.prepare(most, depth_);
  contour_.prepare(most);
  coefficient_.reserve(most);
  second_coefficient_.reserve(most);
}

void KrylovSpace::weigh_start() {
  size_ = used_ = 0;
  exhausted_ = !(length_ > 0);
  if (exhausted_) return;
  const double inverse = 1 / length_;
  auto& v = basis_.front();
  for_each_entry(v.size(), [&](std::size_t i) { v[i] *= inverse; });
  std::fill(part_in_norm_.begin(), part_in_norm_.end(), -1.0);
  matrix_.clear();
}

void KrylovSpace::extend() {
  const std::size_t j = size_++;
  ++products_;
  if (basis_.size() <= j + 1) basis_.emplace_back(reduction_->size());
  StateVector& w = basis_[j + 1];
  const std::size_t first = j + 1 > depth_ ? j + 1 - depth_ : 0;
  const auto& kernel = arnoldi_kernels().front();
  double part = jacobian_->multiply(basis_[j].data(), basis_[first].data(), w.data());
  double square = 0;
  for (std::size_t i = first; i <= j; ++i) {
    matrix_.at(i, j) = part;
    const StateVector& v = basis_[i];
    const StateVector& next = i < j ? basis_[i + 1] : w;
    const double sum = reduction_->sum_of_ranges([&](std::size_t from, std::size_t to) {
      return kernel.subtract(w.data(), part, v.data(), next.data(), from, to);
    });
    (i < j ? part : square) = sum;
  }
  const double length = std::sqrt(square);
  matrix_.at(j + 1, j) = length;
  // What is left after subtracting parts of this size is rounding.
  const double largest = std::abs(matrix_.at(j, j)) + (j > 0 ? matrix_.at(j, j - 1) : 0);
  exhausted_ = !(length > 1e-14 * largest);
  if (exhausted_) return;
  const double inverse = 1 / length;
  for_each_entry(w.size(), [&](std::size_t i) { w[i] *= inverse; });
}

double KrylovSpace::part_in_norm(std::size_t vector) {
  double& part = part_in_norm_[vector];
  if (part < 0) {
    const auto inverse = jacobian_->inverse();
    const auto& v = basis_[vector];
    part = norm_->of([&](std::size_t i) { return inverse[i] * v[i]; });
  }
  return part;
}

/// The integral over the step of the residual: w(s) = s^k phi_k(sJ) b solves w' = J w + s^(k-1)/(k-1)! b, and
/// the integral of s^k phi_k is s^(k+1) phi_(k+1).
double KrylovSpace::error(std::size_t m, double h, int k) {
  contour_.solve(matrix_, m, h);
  const double small = std::abs(contour_.entry(k + 1, m - 1));
  return length_ * h * h * matrix_.at(m, m - 1) * small * part_in_norm(m);
}

bool KrylovSpace::reach(double h, int k, double allowed) {
  used_ = 0;
  if (!(length_ > 0)) return true;
  for (std::size_t m = std::min<std::size_t>(2, most_);; m = std::min(most_, m + 1 + m / 16)) {
    while (size_ < m && !exhausted_) extend();
    used_ = std::min(m, size_);
    if (exhausted_ && size_ <= m) return true;
    if (error(m, h, k) <= allowed) return true;
    if (m == most_) return false;
  }
}

void KrylovSpace::find_coefficients(std::span<const Term> terms, std::vector<double>& out) {
  out.assign(used_, 0.0);
  if (used_ == 0) return;
  double solved = -1;
  for (const auto& term : terms) {
    if (term.step != solved) contour_.solve(matrix_, used_, term.step);
    solved = term.step;
    for (std::size_t j = 0; j < used_; ++j)
      out[j] += length_ * term.factor * term.step * contour_.entry(term.k, j);
  }
}

}  // namespace superstep
