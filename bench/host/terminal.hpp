#pragma once
/// What the program says on stderr, and whether it may use colours.

#include <exception>
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

/// Data on stdout while a computation goes on. Where they cannot be written nothing is lost but they: `end`
/// says so, once all results are kept.
class DataInBetween {
 public:
  void print(std::string_view text);
  /// Throws OutputError where something could not be printed.
  void end() const;

 private:
  std::exception_ptr failed_;
};

/// Text on stderr as it is. Never throws and allocates nothing: what cannot be said is not said.
void say(std::string_view text) noexcept;

/// "superstep: <text>" on stderr, in one line whatever the text holds. Never throws and allocates nothing, so
/// that it can say what went wrong where nothing works any more.
void note(std::string_view text) noexcept;
/// "superstep: <kind><text>", e.g. "superstep: error: ...".
void note(std::string_view kind, std::string_view text) noexcept;
/// "superstep: warning: <text>" for each one.
void warn(const std::vector<std::string>& texts) noexcept;

/// To be called once, first: a file opened later must not become the standard output of somebody who closed
/// his, and a full file or a closed pipe is an error to report, not a signal to die of.
void prepare_streams() noexcept;

}  // namespace superstep
