#pragma once
/// Files that the build put into the program.

#include <string_view>

namespace superstep {

/// Content of an embedded file by its name, "report.css" for instance; empty when it was not there at build
/// time. Which files there are stands in reports/html/embed.cmake.
[[nodiscard]] std::string_view embedded_file(std::string_view name) noexcept;

}  // namespace superstep
