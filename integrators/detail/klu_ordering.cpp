#include "integrators/detail/klu_ordering.hpp"

#include <cholmod.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace superstep {
namespace {

constexpr int amd_code = 0, colamd_code = 1, own_code = 3;  // KLU's `ordering`

std::vector<SuiteSparse_long> nested_dissection(const SparsePattern& pattern) {
  std::vector<SuiteSparse_long> column_begin(pattern.column_begin.begin(), pattern.column_begin.end());
  std::vector<SuiteSparse_long> row(pattern.row.begin(), pattern.row.end());
  std::vector<SuiteSparse_long> permutation(pattern.diagonal.size());
  if (row.size() == permutation.size()) {  // a diagonal: METIS refuses it, and any order will do
    std::iota(permutation.begin(), permutation.end(), 0);
    return permutation;
  }
  cholmod_common cholmod;
  cholmod_l_start(&cholmod);
  cholmod.print = 0;
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = permutation.size();
  matrix.nzmax = row.size();
  matrix.p = column_begin.data();
  matrix.i = row.data();
  matrix.stype = 1;  // symmetric pattern: the upper triangle speaks for both
  matrix.itype = CHOLMOD_LONG;
  matrix.xtype = CHOLMOD_PATTERN;
  matrix.dtype = CHOLMOD_DOUBLE;
  matrix.sorted = matrix.packed = 1;
  const int ok = cholmod_l_metis(&matrix, nullptr, 0, 1, permutation.data(), &cholmod);
  cholmod_l_finish(&cholmod);
  if (!ok) throw std::runtime_error("CHOLMOD's METIS ordering failed; use ordering=amd");
  return permutation;
}

}  // namespace

KluOrdering::KluOrdering(const std::string& name, const SparsePattern& pattern)
    : klu_code_(name == "metis"    ? own_code
                : name == "colamd" ? colamd_code
                                   : amd_code),
      nonzeros_(static_cast<SuiteSparse_long>(pattern.row.size())) {
  if (klu_code_ == own_code) permutation_ = nested_dissection(pattern);
}

void KluOrdering::apply(klu_l_common& common) noexcept {
  common.ordering = klu_code_;
  common.btf = 0;  // a connected symmetric pattern has one block; KLU then orders the whole matrix
  if (klu_code_ != own_code) return;
  common.user_order = copy_permutation;
  common.user_data = this;
}

SuiteSparse_long KluOrdering::copy_permutation(SuiteSparse_long /*n*/, SuiteSparse_long* /*column_begin*/,
                                               SuiteSparse_long* /*row*/, SuiteSparse_long* permutation,
                                               klu_l_common* common) {
  const auto& self = *static_cast<const KluOrdering*>(common->user_data);
  std::copy(self.permutation_.begin(), self.permutation_.end(), permutation);
  return self.nonzeros_;  // KLU expects an estimate of the fill, > 0
}

}  // namespace superstep
