#pragma once
/// Sparsity of a Jacobian.

#include <cstdint>
#include <vector>

namespace superstep {

/// Compressed columns, rows ascending; the diagonal is always present.
struct SparsePattern {
  std::vector<std::int64_t> column_begin;  ///< [n+1]
  std::vector<std::int64_t> row;           ///< [nnz]
  std::vector<std::int64_t> diagonal;      ///< [n] position of (i,i) in `row`
};

}  // namespace superstep
