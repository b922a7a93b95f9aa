#pragma once
/// Columns of a table that a case names.

#include <optional>
#include <string>

#include "core/text/delimited.hpp"

namespace superstep {

/// Place of a column, upper and lower case being the same, with a unit behind its name or not. A table
/// without a header has none by name: then `fallback` is it, if there is one. Throws InputError, beginning
/// with `where`, that lists the columns that are there.
[[nodiscard]] std::size_t column_named(const DelimitedTable& table, const std::string& name,
                                       const std::string& where, std::optional<std::size_t> fallback = {});

/// A finite number in the present row. Throws InputError.
[[nodiscard]] double number_in(const DelimitedTable& table, std::size_t column);

}  // namespace superstep
