#pragma once
/// Fill-reducing orderings for KLU. SUNDIALS' default, COLAMD, is made for unsymmetric patterns and costs ten
/// times the work on a conduction network.

#include <klu.h>

#include <string>
#include <vector>

#include "rhs/rhs.hpp"

namespace superstep {

/// An ordering analysed once and handed to any number of KLU factorizations of the same pattern.
class KluOrdering {
 public:
  /// `metis` (nested dissection through CHOLMOD) is computed here; `amd` and `colamd` are left to KLU.
  /// Throws std::runtime_error when METIS fails.
  KluOrdering(const std::string& name, const SparsePattern& pattern);
  /// Makes KLU use it. The ordering must outlive the factorization.
  void apply(klu_l_common& common) noexcept;

 private:
  static SuiteSparse_long copy_permutation(SuiteSparse_long n, SuiteSparse_long* column_begin,
                                           SuiteSparse_long* row, SuiteSparse_long* permutation,
                                           klu_l_common* common);

  int klu_code_;
  std::vector<SuiteSparse_long> permutation_;
  SuiteSparse_long nonzeros_;
};

}  // namespace superstep
