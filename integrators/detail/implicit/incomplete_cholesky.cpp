#include "integrators/detail/implicit/incomplete_cholesky.hpp"

#include <algorithm>
#include <cmath>

#include "parallel/partition.hpp"

namespace superstep {

IncompleteCholesky::IncompleteCholesky(Rhs& rhs) : rhs_(rhs), jacobian_(rhs) {
  for (const double capacity : rhs.capacities()) root_.push_back(std::sqrt(capacity));
  scaled_.resize(static_cast<Eigen::Index>(rhs.size()));
  for (const auto& field : rhs.fields()) {
    const std::size_t rows = block_rows_among(static_cast<std::int64_t>(field.total()));
    for (std::size_t first = 0; first < field.count; first += rows) {
      auto& block = *blocks_.emplace_back(std::make_unique<Block>());
      block.first = field.offset + first;
      block.size = std::min(rows, field.count - first);
      build_block(block);
    }
  }
}

void IncompleteCholesky::build_block(Block& block) {
  const auto& pattern = rhs_.own_pattern();
  const std::size_t first = block.first, end = first + block.size;
  std::vector<Eigen::Triplet<double, int>> triplets;
  for (std::size_t j = first; j < end; ++j)
    for (auto k = pattern.column_begin[j]; k < pattern.column_begin[j + 1]; ++k) {
      const auto i = static_cast<std::size_t>(pattern.row[static_cast<std::size_t>(k)]);
      if (i < j || i >= end) continue;
      triplets.emplace_back(static_cast<int>(i - first), static_cast<int>(j - first), 1.0);
      block.position.push_back({static_cast<std::size_t>(k), pattern.position(j, i), i, j});
    }
  const auto n = static_cast<Eigen::Index>(block.size);
  block.lower.resize(n, n);
  block.lower.setFromTriplets(triplets.begin(),
                              triplets.end());  // by columns, rows rising: the order of `position`
  block.factor.analyzePattern(block.lower);
}

bool IncompleteCholesky::set(double c, double t, std::span<const double> y) {
  const bool still_valid = jacobian_.bring_to(t, y);
  if (still_valid && c == shift_) return true;
  shift_ = c;
  const bool symmetric = rhs_.traits().symmetric;
  bool all_good = true;
  for (const auto& block : blocks_) {
    double* values = block->lower.valuePtr();
    for (std::size_t k = 0; k < block->position.size(); ++k) {
      const auto [entry, mirror, row, column] = block->position[k];
      const double ratio = root_[row] / root_[column];
      const double lower = jacobian_.values()[entry] * ratio;
      const double upper = symmetric ? lower : jacobian_.values()[mirror] / ratio;
      values[k] = (row == column ? 1.0 : 0.0) - c * 0.5 * (lower + upper);
    }
    block->factor.factorize(block->lower);
    all_good = all_good && block->factor.info() == Eigen::Success;
  }
  ++factorizations_;
  return !rhs_.reduction().any(!all_good);
}

void IncompleteCholesky::apply(std::span<const double> r, std::span<double> z) {
  const auto n = static_cast<Eigen::Index>(r.size());
  const Eigen::Map<const Eigen::VectorXd> root(root_.data(), n), residual(r.data(), n);
  scaled_ = root.cwiseProduct(residual);
  for (const auto& block : blocks_) {
    auto part =
        scaled_.segment(static_cast<Eigen::Index>(block->first), static_cast<Eigen::Index>(block->size));
    part = block->factor.solve(part).eval();
  }
  Eigen::Map<Eigen::VectorXd>(z.data(), n) = scaled_.cwiseQuotient(root);
}

}  // namespace superstep
