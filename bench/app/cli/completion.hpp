#pragma once
/// Completion scripts for shells, made from the command line that the program understands.

#include <span>
#include <string>
#include <vector>

namespace superstep {

/// One option of a command.
struct OptionShape {
  std::string name;  ///< "--integrator"
  std::string meaning;
  bool takes_value = false;
  std::vector<std::string> words;  ///< values that can be offered; empty = files
};

/// One command with its options.
struct CommandShape {
  std::string name, does;
  std::vector<OptionShape> options;
};

/// Script for "bash", "zsh" or "fish"; throws UsageError for another shell.
[[nodiscard]] std::string completion_script(const std::string& shell, std::span<const CommandShape> commands);

}  // namespace superstep
