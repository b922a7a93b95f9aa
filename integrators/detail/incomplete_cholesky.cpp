#include "integrators/detail/incomplete_cholesky.hpp"

#include <cmath>

#include "integrators/integrator.hpp"

namespace superstep {

IncompleteCholesky::IncompleteCholesky(Rhs& rhs) : rhs_(rhs), jacobian_(rhs) {
  if (!rhs.traits().symmetric)
    throw Refused("this solver needs a Jacobian that is symmetric in the capacity inner product; use klu");
  for (const double capacity : rhs.capacities()) root_.push_back(std::sqrt(capacity));
  scaled_.resize(static_cast<Eigen::Index>(rhs.size()));
  build_lower_triangle();
}

void IncompleteCholesky::build_lower_triangle() {
  const auto& pattern = rhs_.pattern();
  const auto n = static_cast<Eigen::Index>(rhs_.size());
  std::vector<Eigen::Triplet<double, int>> triplets;
  for (std::size_t j = 0; j < rhs_.size(); ++j)
    for (auto k = pattern.column_begin[j]; k < pattern.column_begin[j + 1]; ++k) {
      const auto i = static_cast<std::size_t>(pattern.row[static_cast<std::size_t>(k)]);
      if (i < j) continue;
      triplets.emplace_back(static_cast<int>(i), static_cast<int>(j), 1.0);
      position_.push_back({static_cast<std::size_t>(k), i, j});
    }
  lower_.resize(n, n);
  lower_.setFromTriplets(triplets.begin(),
                         triplets.end());  // by columns, rows rising: the order of `position_`
  factor_.analyzePattern(lower_);
}

bool IncompleteCholesky::set(double c, double t, std::span<const double> y) {
  const bool stands = jacobian_.stands_at(t, y);
  if (stands && c == shift_) return true;
  shift_ = c;
  double* values = lower_.valuePtr();
  for (std::size_t k = 0; k < position_.size(); ++k) {
    const auto [entry, row, column] = position_[k];
    values[k] = (row == column ? 1.0 : 0.0) - c * jacobian_.values()[entry] * root_[row] / root_[column];
  }
  factor_.factorize(lower_);
  ++factorizations_;
  return factor_.info() == Eigen::Success;
}

void IncompleteCholesky::apply(std::span<const double> r, std::span<double> z) {
  const auto n = static_cast<Eigen::Index>(r.size());
  const Eigen::Map<const Eigen::VectorXd> root(root_.data(), n), residual(r.data(), n);
  scaled_ = root.cwiseProduct(residual);
  scaled_ = factor_.solve(scaled_);
  Eigen::Map<Eigen::VectorXd>(z.data(), n) = scaled_.cwiseQuotient(root);
}

}  // namespace superstep
