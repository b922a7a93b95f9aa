#pragma once
/// Values at the start: one for all, or one for each particle or node.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/text/toml.hpp"
#include "packing/packing.hpp"

namespace superstep {

/// Reads `initial` of a table: a number (0 when it is left out), `{ column = "name" }` of the packing file,
/// or `{ file = "final.csv", column = "name" }`, whose rows go by their column `id`.
///   id       [n] of particles or nodes
///   packing  where there is one; else a column needs its file
///   unit     "K" or "V", which the name of a column may state; empty = either
/// Throws InputError for a column that is missing, has gaps or states another unit, and for ids that do not
/// match.
[[nodiscard]] std::vector<double> read_initial(TomlTable& table, std::span<const std::int64_t> id,
                                               const Packing* packing, std::string_view unit = {});

}  // namespace superstep
