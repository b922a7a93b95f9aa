#pragma once
/// Packing files that users have, told apart by their content.

#include <string>

#include "packing/packing.hpp"
#include "packing/read_options.hpp"
#include "packing/units.hpp"

namespace superstep {

/// Reads a packing in any of the formats of README.md (the last frame of a file with several), gzipped or
/// not. Nothing that the file states is ignored: its unit of length, its box, what of it is periodic, every
/// column. Checks: numbers finite, radii > 0, ids unique, no coincident centres, at least one particle,
/// centres not far outside the box, a box of some volume where it is periodic, no two statements that
/// contradict each other. Along periodic edges centres are moved into the cell. Throws InputError that names
/// file, line, value and rule.
[[nodiscard]] Packing read_packing(const std::string& path, const PackingOptions& options = {});
///   unit [m]  length of one unit of the file, > 0
[[nodiscard]] Packing read_packing(const std::string& path, double unit);

/// What the user says about the box and its sides, on top of what the packing at `path` says: periodic edges
/// get their images. Throws InputError.
void apply_box(const PackingOptions& options, const std::string& path, Packing& packing);

/// Name of the format that a file's content is recognised as, tables left out, which nearly everything could
/// be; empty for none. Throws InputError for a file that cannot be read.
[[nodiscard]] std::string recognised_format(const std::string& path);

/// True for a file that `read_packing` takes.
[[nodiscard]] bool reads_as_packing(const std::string& path);

/// CSV text `id,x,y,z,radius[,material][,attributes]` in metres, which its first line states, with enough
/// digits to read back the same contacts; comments at its top state the cell.
[[nodiscard]] std::string packing_csv(const Packing& packing);
/// Its head, and its lines, for one that is written in parts.
[[nodiscard]] std::string packing_csv_head(const Packing& packing);
[[nodiscard]] std::string packing_csv_rows(const Packing& packing);

}  // namespace superstep
