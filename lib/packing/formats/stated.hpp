#pragma once
/// What the comments at the top of a file state, as in `# length_unit = "um"`.

#include <optional>
#include <string>
#include <string_view>

#include "packing/formats/formats.hpp"

namespace superstep {

/// A value with the line that states it.
struct StatedValue {
  std::string text;  ///< without quotes
  std::size_t line = 0;
};

/// Value of `# key = value` among the comments at the top, below a header, too; nothing when it is not there.
/// The key in upper or lower case, `:` for `=` and `%` for `#` will do.
[[nodiscard]] std::optional<StatedValue> stated_value(std::string_view text, std::string_view key);

/// Unit of `# length_unit = "um"`. Throws InputError for a unit that does not exist.
[[nodiscard]] std::optional<StatedUnit> stated_length_unit(const std::string& path, std::string_view text);

/// The first word of the comments at the top that is a unit of length smaller than a metre, as in "# all in
/// mm"; nothing where there is none.
[[nodiscard]] std::optional<StatedValue> mentioned_length_unit(std::string_view text);

/// Cell of `# cell = "ox oy oz ax ay az bx by bz cx cy cz"` and `# periodic = "xyz"`, in units of the file.
/// Throws InputError.
[[nodiscard]] std::optional<Cell> stated_cell(const PackingFile& file);
/// Those two lines for a cell in metres.
[[nodiscard]] std::string cell_comment(const Cell& cell);

/// Which edges a word such as "xy" or "none" calls periodic. Throws InputError beginning with `where`.
[[nodiscard]] std::array<bool, 3> periodic_edges(const std::string& word, const std::string& where);

}  // namespace superstep
