#pragma once
/// Files that may have lost their end.

#include <string>
#include <string_view>

namespace superstep {

/// What to say of a text whose last line, a number or a word at its end, has no end; empty for others.
/// Programs end every line, so that a file of theirs may be cut inside its last number, and still be whole by
/// its counts.
///   path  to begin with
[[nodiscard]] inline std::string unfinished_line(const std::string& path, std::string_view text) {
  constexpr std::string_view digits = "0123456789.";
  if (text.empty() || digits.find(text.back()) == std::string_view::npos) return {};
  return path + ": its last line has no end; if it was cut off, its last number is another one";
}

}  // namespace superstep
