#pragma once
/// Units that stand behind a name: "P [mW]", "x (um)".

#include <string_view>

namespace superstep {

struct NameAndUnit {
  std::string_view name, unit;  ///< without blanks around them; unit is empty where there are no brackets
};
[[nodiscard]] NameAndUnit split_bracketed_unit(std::string_view written) noexcept;

}  // namespace superstep
