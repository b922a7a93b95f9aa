#pragma once
/// The command line. CLI11 2.1.2 misreads numbers ("-5" for an unsigned, '' as 0), so it only ever sees
/// strings here; numbers go through core/number.hpp.

#include <string>
#include <vector>

#include "bench/commands.hpp"

namespace superstep {

/// Arguments without the program's name. Throws UsageError in one line, with the nearest valid name for a
/// mistyped one.
[[nodiscard]] Command parse_command_line(const std::vector<std::string>& arguments);

}  // namespace superstep
