/// superstep completion: what a shell needs to complete our commands and options.

#include "bench/app/cli/cli_arguments.hpp"
#include "bench/app/cli/command_entry.hpp"
#include "bench/app/cli/completion.hpp"
#include "bench/app/commands.hpp"
#include "core/error.hpp"
#include "integrators/registry.hpp"

namespace superstep {

namespace {

Command completion_from_line(const Arguments& values) {
  if (values.json) throw UsageError("completion: prints a script; leave --json out");
  if (values.cases.empty()) throw UsageError("completion: the shell is missing: bash, zsh or fish");
  return CompletionCommand{.common = common_options(values),
                           .shell = single_case(values, "completion", "the name of a shell")};
}

}  // namespace

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

CommandEntry completion_command() {
  return {.name = "completion",
          .does = "completion script for a shell",
          .examples =
              "  source <(superstep completion bash)\n"
              "  source <(superstep completion zsh)\n"
              "  superstep completion fish | source",
          .positional = "SHELL",
          .positional_meaning = "bash, zsh or fish",
          .options = {},
          .make = completion_from_line};
}

}  // namespace superstep
