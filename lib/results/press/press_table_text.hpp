#pragma once
/// A table of presses in words.

#include <span>
#include <string>

#include "results/press/press_table.hpp"
#include "results/text/plain_table.hpp"

namespace superstep {

/// Means over the beds with their spread, of one case or several.
[[nodiscard]] PlainTable press_table_means(std::span<const PressTableCell> cells);
/// "Less springback with longer hold in 18 of 18 pairs, with higher densification in 18 of 18".
[[nodiscard]] std::string press_table_trends(std::span<const PressTableRow> rows);
/// Means, what failed and why, and the trends, for the terminal.
[[nodiscard]] std::string press_table_text(std::span<const PressTableRow> rows, bool color);

}  // namespace superstep
