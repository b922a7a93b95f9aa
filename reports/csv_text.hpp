#pragma once
/// Cells of CSV files that we write.

#include <string>
#include <string_view>

namespace superstep {

/// Text as one CSV cell: quoted when it holds a comma, a quote or a line break (RFC 4180).
[[nodiscard]] std::string csv_cell(std::string_view text);

/// Shortest decimal text that reads back as the same double.
[[nodiscard]] std::string csv_cell(double value);

}  // namespace superstep
