#include "integrators/detail/implicit/incomplete_cholesky.hpp"

#include <algorithm>
#include <cmath>

namespace superstep {

IncompleteCholesky::IncompleteCholesky(Rhs& rhs) : rhs_(rhs), jacobian_(rhs) {
  for (const double capacity : rhs.capacities()) root_.push_back(std::sqrt(capacity));
  scaled_.resize(static_cast<Eigen::Index>(rhs.size()));
  build_lower_triangle();
}

void IncompleteCholesky::build_lower_triangle() {
  const auto& pattern = rhs_.pattern();
  const auto n = static_cast<Eigen::Index>(rhs_.size());
  const auto fields = rhs_.fields();
  const auto field_of = [&](std::size_t i) { return fields.size() > 1 && i >= fields[1].offset ? 1 : 0; };
  std::vector<Eigen::Triplet<double, int>> triplets;
  for (std::size_t j = 0; j < rhs_.size(); ++j)
    for (auto k = pattern.column_begin[j]; k < pattern.column_begin[j + 1]; ++k) {
      const auto i = static_cast<std::size_t>(pattern.row[static_cast<std::size_t>(k)]);
      if (i < j || field_of(i) != field_of(j)) continue;
      triplets.emplace_back(static_cast<int>(i), static_cast<int>(j), 1.0);
      position_.push_back({static_cast<std::size_t>(k), pattern.position(j, i), i, j});
    }
  lower_.resize(n, n);
  lower_.setFromTriplets(triplets.begin(),
                         triplets.end());  // by columns, rows rising: the order of `position_`
  factor_.analyzePattern(lower_);
}

bool IncompleteCholesky::set(double c, double t, std::span<const double> y) {
  const bool still_valid = jacobian_.bring_to(t, y);
  if (still_valid && c == shift_) return true;
  shift_ = c;
  const bool symmetric = rhs_.traits().symmetric;
  double* values = lower_.valuePtr();
  for (std::size_t k = 0; k < position_.size(); ++k) {
    const auto [entry, mirror, row, column] = position_[k];
    const double ratio = root_[row] / root_[column];
    const double lower = jacobian_.values()[entry] * ratio;
    const double upper = symmetric ? lower : jacobian_.values()[mirror] / ratio;
    values[k] = (row == column ? 1.0 : 0.0) - c * 0.5 * (lower + upper);
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
