#pragma once
/// Units that stand behind a name: "P [mW]", "x (um)".

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace superstep {

struct NameAndUnit {
  std::string_view name, unit;  ///< without blanks around them; unit is empty where there are no brackets
};
[[nodiscard]] NameAndUnit split_bracketed_unit(std::string_view written) noexcept;

/// The name without its unit, in lower case.
[[nodiscard]] std::string bare_name(std::string_view written);

/// Place of the name that is meant: the same letters before those that differ in case, with a unit behind it
/// or not. Nothing where there is none; throws InputError, beginning with `where`, where several are as good.
[[nodiscard]] std::optional<std::size_t> place_of_name(std::span<const std::string> names,
                                                       std::string_view wanted, const std::string& where);

/// True for units in which this program takes numbers without converting them.
[[nodiscard]] bool is_plain_unit(std::string_view unit) noexcept;

/// Throws InputError, beginning with `where`, for the name of a column that states another one.
void require_plain_unit(std::string_view written, const std::string& where);

}  // namespace superstep
