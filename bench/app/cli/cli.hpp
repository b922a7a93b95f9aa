#pragma once
/// From the command line to a command: numbers parsed strictly, combinations checked.

#include <string>
#include <vector>

#include "bench/app/commands.hpp"

namespace superstep {

/// Arguments without the program's name. Throws UsageError in one line, with the nearest valid name for a
/// mistyped one.
[[nodiscard]] Command parse_command_line(const std::vector<std::string>& arguments);

}  // namespace superstep
