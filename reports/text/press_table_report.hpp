#pragma once
/// A table of presses for the terminal.

#include <span>
#include <string>

#include "results/press/press_table.hpp"

namespace superstep {

/// Means over the beds with their spread, and the trends in words.
[[nodiscard]] std::string press_table_text(std::span<const PressTableRow> rows, bool color);
/// "less springback with longer hold in 18 of 18 pairs, with higher densification in 18 of 18".
[[nodiscard]] std::string press_table_trends(std::span<const PressTableRow> rows);

}  // namespace superstep
