#pragma once
/// Sparsity of a Jacobian.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace superstep {

/// Compressed columns, rows ascending; the diagonal is always present.
struct SparsePattern {
  std::vector<std::int64_t> column_begin;  ///< [n+1]
  std::vector<std::int64_t> row;           ///< [nnz]
  std::vector<std::int64_t> diagonal;      ///< [n] position of (i,i) in `row`

  /// Position of (i, j) in `row`, which must be there.
  [[nodiscard]] std::size_t position(std::size_t i, std::size_t j) const noexcept {
    const auto first = row.begin() + column_begin[j], last = row.begin() + column_begin[j + 1];
    return static_cast<std::size_t>(std::lower_bound(first, last, static_cast<std::int64_t>(i)) -
                                    row.begin());
  }
};

}  // namespace superstep
