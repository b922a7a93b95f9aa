#pragma once
/// Units that columns of values state behind their names.

#include <string>
#include <string_view>

#include "core/text/bracketed_unit.hpp"
#include "core/text/delimited.hpp"

namespace superstep {

/// "temperature [C]" is in C, "T_degC" in degC; the unit is empty where a name states none, as "f_Temp[0]"
/// does.
[[nodiscard]] NameAndUnit split_column_unit(std::string_view written);

/// Throws InputError that begins with `where` for a column whose name states another unit than this one.
///   unit  "K" or "V"; empty = either
void require_column_unit(std::string_view name, std::string_view unit, const std::string& where);

/// A rule by which a comment is a header also where one of its names states a unit.
///   unit_of  unit that a name states; empty = none
[[nodiscard]] HeaderRule or_states_unit(HeaderRule rule, std::string_view unit_of(std::string_view name));

}  // namespace superstep
