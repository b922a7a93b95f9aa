#pragma once
/// Cells of CSV files that we write.

#include <string>
#include <string_view>

namespace superstep {

/// Text as one CSV cell: quoted when it holds a comma, a quote or a line break (RFC 4180). Text that a
/// spreadsheet would take for a formula (it begins with = + - @, a tab or a line break) gets an apostrophe in
/// front.
[[nodiscard]] std::string csv_cell(std::string_view text);

/// Shortest decimal text that reads back as the same double.
[[nodiscard]] std::string csv_cell(double value);

/// Text that an unquoted cell stands for: without the apostrophe.
[[nodiscard]] std::string csv_text_of(std::string_view cell);

}  // namespace superstep
