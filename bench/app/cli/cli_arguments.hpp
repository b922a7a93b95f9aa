#pragma once
/// The shape of the command line: commands, options, help texts. CLI11 2.1.2 misreads numbers ("-5" for an
/// unsigned, '' as 0), so it only ever sees strings; the commands make numbers of them.

#include <string>
#include <vector>

#include "bench/app/cli/command_entry.hpp"
#include "bench/app/cli/completion.hpp"

namespace superstep {

/// Arguments without the program's name. Throws UsageError for unknown commands and options and for empty
/// values.
[[nodiscard]] Arguments read_arguments(const std::vector<std::string>& line);

/// Commands and options, as a shell completes them.
[[nodiscard]] std::vector<CommandShape> command_shapes();

}  // namespace superstep
