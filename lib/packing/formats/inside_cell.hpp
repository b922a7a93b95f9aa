#pragma once
/// Positions against the box that a file states: far outside it, they are read from the wrong columns.

#include <span>
#include <string>

#include "packing/packing.hpp"

namespace superstep {

/// Throws InputError when a centre lies farther outside the packing's cell than half its height and a
/// diameter; leaves a warning when some lie outside by more than their radius.
///   unwrapped  along periodic edges positions may be anywhere
///   lines      [n] of the file, which states the box; empty = it is that of [packing] box
void require_inside_cell(Packing& packing, bool unwrapped, const std::string& path,
                         std::span<const std::size_t> lines);

}  // namespace superstep
