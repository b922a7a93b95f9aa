#pragma once
/// The program as a function: what `main` calls, and tests call without starting a process.

#include <string>
#include <vector>

namespace superstep {

/// Carries out a command line, without the program's name; what went wrong is said on stderr in one line.
/// Returns the exit code.
[[nodiscard]] int run_program(const std::vector<std::string>& arguments);

}  // namespace superstep
