#include "bench/app/cli/cli.hpp"

#include "bench/app/cli/cli_arguments.hpp"

namespace superstep {

Command parse_command_line(const std::vector<std::string>& arguments) {
  const Arguments values = read_arguments(arguments);
  for (const auto& entry : command_entries())
    if (entry.name == values.command) return entry.make(values);
  return ShowText{values.text};
}

}  // namespace superstep
