#pragma once
/// The second line of extended XYZ: what it says of the box and of the columns.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "packing/cell.hpp"

namespace superstep {

/// Values by their keys in lower case, quotes and outer brackets taken off.
using XyzPairs = std::map<std::string, std::string>;

/// `key=value`, `key = "several values"`, `key=[1, 2]`, `key={1 2}`; words without a value are left out.
[[nodiscard]] XyzPairs xyz_pairs(std::string_view comment);

/// The box of Lattice, Origin and pbc; nothing without a Lattice. Throws InputError for numbers that are
/// none, for words that are no truth values, and for what is periodic without a Lattice.
///   path, line  of the comment, for messages
[[nodiscard]] std::optional<Cell> xyz_cell(const XyzPairs& pairs, const std::string& path, std::size_t line);

/// Names of the columns from `Properties=species:S:1:pos:R:3:radius:R:1`: species, pos:0, pos:1, pos:2,
/// radius. Throws InputError that begins with `place`.
[[nodiscard]] std::vector<std::string> xyz_property_names(const std::string& properties,
                                                          const std::string& place);

}  // namespace superstep
