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

/// Moves rows of like length side by side, longest first, within windows of 1024 rows of `order`: rows that
/// are stored in slices then need little padding, and neighbours stay near each other.
void group_by_length(std::span<const std::int64_t> row_begin, std::vector<std::int32_t>& order);

}  // namespace superstep
