#include "rhs/kernels/jacobian_assembly.hpp"

#include <algorithm>

namespace superstep {

SparsePattern JacobianAssembly::build_from(std::size_t n, const std::vector<Place>& places) {
  // Dealt out to their columns first: each is short, and sorting all places at once would cost ten times
  // more.
  std::vector<std::int64_t> begin(n + 1, 0);
  for (const auto& [column, row] : places) ++begin[static_cast<std::size_t>(column) + 1];
  for (std::size_t j = 0; j < n; ++j) begin[j + 1] += begin[j] + 1;  // and the diagonal
  std::vector<std::int64_t> rows(static_cast<std::size_t>(begin[n])), next(begin.begin(), begin.end() - 1);
  for (std::size_t j = 0; j < n; ++j)
    rows[static_cast<std::size_t>(next[j]++)] = static_cast<std::int64_t>(j);
  for (const auto& [column, row] : places)
    rows[static_cast<std::size_t>(next[static_cast<std::size_t>(column)]++)] = row;

  SparsePattern pattern;
  pattern.column_begin.assign(n + 1, 0);
  pattern.row.reserve(rows.size());
  for (std::size_t j = 0; j < n; ++j) {
    const auto first = rows.begin() + begin[j], last = rows.begin() + begin[j + 1];
    std::sort(first, last);
    const auto end = std::unique(first, last);
    for (auto row = first; row != end; ++row) {
      if (*row == static_cast<std::int64_t>(j))
        pattern.diagonal.push_back(static_cast<std::int64_t>(pattern.row.size()));
      pattern.row.push_back(*row);
    }
    pattern.column_begin[j + 1] = static_cast<std::int64_t>(pattern.row.size());
  }

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
