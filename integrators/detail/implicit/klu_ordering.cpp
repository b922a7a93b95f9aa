#include "integrators/detail/implicit/klu_ordering.hpp"

#include <cholmod.h>

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

namespace superstep {
namespace {

constexpr int amd_code = 0, colamd_code = 1, own_code = 3;  // KLU's `ordering`

/// Upper triangle of the pattern of A + A^T, compressed columns.
struct UpperPattern {
  UpperPattern(SuiteSparse_long n, const SuiteSparse_long* begin, const SuiteSparse_long* rows)
      : column_begin(static_cast<std::size_t>(n) + 1, 0) {
    std::vector<std::pair<SuiteSparse_long, SuiteSparse_long>> entries;  // column, row
    for (SuiteSparse_long j = 0; j < n; ++j)
      for (auto k = begin[j]; k < begin[j + 1]; ++k)
        entries.emplace_back(std::max(rows[k], j), std::min(rows[k], j));
    std::sort(entries.begin(), entries.end());
    entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
    for (const auto& [column, entry_row] : entries) {
      ++column_begin[static_cast<std::size_t>(column) + 1];
      row.push_back(entry_row);
    }
    for (std::size_t j = 0; j + 1 < column_begin.size(); ++j) column_begin[j + 1] += column_begin[j];
  }
  std::vector<SuiteSparse_long> column_begin, row;
};

bool nested_dissection(SuiteSparse_long n, UpperPattern& pattern, SuiteSparse_long* permutation) noexcept {
  cholmod_common cholmod;
  cholmod_l_start(&cholmod);
  cholmod.print = 0;
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = static_cast<std::size_t>(n);
  matrix.nzmax = pattern.row.size();
  matrix.p = pattern.column_begin.data();
  matrix.i = pattern.row.data();
  matrix.stype = 1;  // the upper triangle speaks for both
  matrix.itype = CHOLMOD_LONG;
  matrix.xtype = CHOLMOD_PATTERN;
  matrix.dtype = CHOLMOD_DOUBLE;
  matrix.sorted = matrix.packed = 1;
  const int ok = cholmod_l_metis(&matrix, nullptr, 0, 1, permutation, &cholmod);
  cholmod_l_finish(&cholmod);
  return ok != 0;
}

/// KLU's hook: permutation of one block. Returns an estimate of the fill, > 0; 0 = failed.
SuiteSparse_long order_block(SuiteSparse_long n, SuiteSparse_long* column_begin, SuiteSparse_long* row,
                             SuiteSparse_long* permutation, klu_l_common* /*common*/) noexcept {
  try {
    UpperPattern pattern(n, column_begin, row);
    return nested_dissection(n, pattern, permutation) ? column_begin[n] + 1 : 0;
  } catch (const std::bad_alloc&) {
    return 0;
  }
}

}  // namespace

void apply_klu_ordering(const std::string& name, klu_l_common& common) noexcept {
  common.btf = 1;
  common.ordering = name == "metis" ? own_code : name == "colamd" ? colamd_code : amd_code;
  if (common.ordering == own_code) common.user_order = order_block;
}

}  // namespace superstep
