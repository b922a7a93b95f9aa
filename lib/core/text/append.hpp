#pragma once
/// Formatted text at the end of a string: large files are put together without a string for each row.

#include <fmt/format.h>

#include <string>

namespace superstep {

void append_formatted(std::string& out, fmt::string_view format, fmt::format_args arguments);

/// append(out, "{},{}\n", x, y). The formatting itself is compiled once, in append.cpp: fmt::format_to would
/// bring all of it into every file that calls it.
template <class... Args>
void append(std::string& out, fmt::format_string<Args...> format, const Args&... arguments) {
  append_formatted(out, format, fmt::make_format_args(arguments...));
}

}  // namespace superstep
