#pragma once
/// Numbers that every method can compute with.

#include <string>

#include "case/scene.hpp"

namespace superstep {

/// Capacities, conductances that are not 0, and coefficients of exchange must lie between 1e-40 and
/// 1e40 in SI units; values and sources not above 1e40. Beyond, squares of what solvers form of them (C/h, K
/// x, their sums) leave the range of a double and the answer would be wrong without a word. Throws InputError
/// with the node or edge. To be called before the right-hand side is built.
void require_workable_numbers(const Scene& scene);
/// The same of nodes and edges of a field.
void require_workable_numbers(const std::string& file, const FieldScene& field, const Graph& graph);

}  // namespace superstep
