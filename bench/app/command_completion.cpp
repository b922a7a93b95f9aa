/// superstep completion: what a shell needs to complete our commands and options.

#include "bench/app/cli_arguments.hpp"
#include "bench/app/commands.hpp"
#include "bench/app/completion.hpp"
#include "core/error.hpp"
#include "integrators/registry.hpp"

namespace superstep {

int execute(const CompletionCommand& command) {
  std::vector<std::string> methods;
  for (const auto& entry : integrators()) methods.push_back(entry.name);
  auto commands = command_shapes();
  for (auto& one : commands)
    for (auto& option : one.options) {
      if (option.name == "--integrator" || option.name == "--reference") option.words = methods;
      if (option.name == "--color") option.words = {"auto", "always", "never"};
    }
  print_data(completion_script(command.shell, commands));
  return static_cast<int>(ExitCode::ok);
}

}  // namespace superstep
