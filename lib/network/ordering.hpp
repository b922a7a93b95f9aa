#pragma once
/// Node orderings for locality: neighbours in the network become neighbours in memory.

#include <cstdint>
#include <span>
#include <vector>

namespace superstep {

/// Reverse Cuthill-McKee order of an undirected graph in CSR form; O(edges log degree) time.
/// Returns order[new position] = old position.
[[nodiscard]] std::vector<std::int32_t> reverse_cuthill_mckee(std::span<const std::int64_t> row_begin,
                                                              std::span<const std::int32_t> neighbour);

}  // namespace superstep
