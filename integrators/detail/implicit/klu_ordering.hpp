#pragma once
/// Fill-reducing orderings for KLU. SUNDIALS' default, COLAMD, is made for unsymmetric patterns and costs ten
/// times the work on a conduction network.

#include <klu.h>

#include <string>

namespace superstep {

/// Makes KLU use an ordering: `metis` (nested dissection through CHOLMOD), `amd` or `colamd`. KLU first
/// splits the matrix into its strongly connected blocks, so that a field that drives another one without
/// answer is factorized apart from it, and orders each block.
void apply_klu_ordering(const std::string& name, klu_l_common& common) noexcept;

}  // namespace superstep
