#include "rhs/kernels/jacobian_assembly.hpp"

#include <algorithm>

namespace superstep {

SparsePattern JacobianAssembly::build_from(std::size_t n, const std::vector<Place>& places) {
  std::vector<Place> sorted = places;
  for (std::size_t i = 0; i < n; ++i)
    sorted.emplace_back(static_cast<std::int64_t>(i), static_cast<std::int64_t>(i));
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());

  SparsePattern pattern;
  pattern.column_begin.assign(n + 1, 0);
  pattern.row.reserve(sorted.size());
  for (const auto& [column, row] : sorted) {
    ++pattern.column_begin[static_cast<std::size_t>(column) + 1];
    if (row == column) pattern.diagonal.push_back(static_cast<std::int64_t>(pattern.row.size()));
    pattern.row.push_back(row);
  }
  for (std::size_t j = 0; j < n; ++j) pattern.column_begin[j + 1] += pattern.column_begin[j];

  position_.clear();
  position_.reserve(places.size());
  for (const auto& [column, row] : places) {
    const auto first = pattern.row.begin() + pattern.column_begin[static_cast<std::size_t>(column)];
    const auto last = pattern.row.begin() + pattern.column_begin[static_cast<std::size_t>(column) + 1];
    position_.push_back(std::lower_bound(first, last, row) - pattern.row.begin());
  }
  return pattern;
}

}  // namespace superstep
