#pragma once
/// Names of columns that the user declares, beside those that a file has.

#include <span>
#include <string>

#include "packing/formats/formats.hpp"

namespace superstep {

/// Nothing is said against names that the file has and that mean nothing here. Throws InputError where both
/// say what a column is, and not the same.
///   names  of the file, as many as are declared
void require_same_meaning(const PackingFile& file, std::span<const std::string> names);

}  // namespace superstep
