#pragma once
/// Units of length by name, and those of the unit styles that particle codes know.

#include <optional>
#include <string>
#include <vector>

namespace superstep {

/// Metres per unit for "m", "mm", "um", "nm", "cm". Throws InputError (beginning with `where`) for any other
/// name.
[[nodiscard]] double length_unit(const std::string& name, const std::string& where);

/// The same for what a column says of itself, micro sign and all; nothing for words that are no unit of
/// length.
[[nodiscard]] std::optional<double> length_unit_of_column(const std::string& name);

/// Name of a unit of length [m] as the case format has it, as in "um"; else its size in metres.
[[nodiscard]] std::string length_unit_name(double metres);

/// Metres per unit of length of a LAMMPS unit style ("si", "cgs", "micro", "nano", "real", "metal",
/// "electron"); 0 for "lj", which has no dimension; nothing for any other name.
[[nodiscard]] std::optional<double> unit_style_length(const std::string& style);
/// Metres per second of a unit of velocity of such a style; nothing where its unit of time is not sure.
[[nodiscard]] std::optional<double> unit_style_velocity(const std::string& style);
/// The styles, in the order of their documentation.
[[nodiscard]] const std::vector<std::string>& unit_styles();

}  // namespace superstep
