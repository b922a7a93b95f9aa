#pragma once
/// What the program says on stderr, and whether it may use colours.

#include <string>
#include <string_view>
#include <vector>

namespace superstep {

enum class ColorMode { automatic, always, never };

/// Colours on stdout: as asked; automatic = on a terminal, unless NO_COLOR is set (no-color.org) or the
/// terminal is dumb.
[[nodiscard]] bool use_color(ColorMode mode);

/// True when somebody watches stderr: only then a progress line makes sense.
[[nodiscard]] bool stderr_is_terminal();

/// Data on stdout, at once. Throws OutputError when it does not get there (full disk, closed pipe).
void print_data(std::string_view text);

/// "superstep: <text>" on stderr.
void note(const std::string& text);
/// "superstep: warning: <text>" for each one.
void warn(const std::vector<std::string>& texts);

}  // namespace superstep
