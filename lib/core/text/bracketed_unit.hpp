#pragma once
/// Units that stand behind a name: "P [mW]", "x (um)".

#include <string>
#include <string_view>

namespace superstep {

struct NameAndUnit {
  std::string_view name, unit;  ///< without blanks around them; unit is empty where there are no brackets
};
[[nodiscard]] NameAndUnit split_bracketed_unit(std::string_view written) noexcept;

/// True for units in which this program takes numbers without converting them.
[[nodiscard]] bool is_plain_unit(std::string_view unit) noexcept;

/// Throws InputError, beginning with `where`, for the name of a column that states another one.
void require_plain_unit(std::string_view written, const std::string& where);

}  // namespace superstep
