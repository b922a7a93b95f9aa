#include "bench/app/cli/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/text/suggest.hpp"
#include "core/text/text_file.hpp"

namespace superstep {
namespace {

std::string names_of(std::span<const CommandShape> commands) {
  std::vector<std::string> names;
  for (const auto& command : commands) names.push_back(command.name);
  return fmt::format("{}", fmt::join(names, " "));
}

std::string options_of(const CommandShape& command) {
  std::vector<std::string> names;
  for (const auto& option : command.options) names.push_back(option.name);
  return fmt::format("{}", fmt::join(names, " "));
}

/// Text inside single quotes of a shell.
std::string quoted_for_shell(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string bash_script(std::span<const CommandShape> commands) {
  std::string out =
      "# Load with: source <(superstep completion bash)\n"
      "_superstep() {\n"
      "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}\n"
      "  COMPREPLY=()\n"
      "  if ((COMP_CWORD == 1)); then\n";
  out +=
      fmt::format("    COMPREPLY=($(compgen -W '{} --help --version' -- \"$current\"))\n    return\n  fi\n",
                  names_of(commands));
  out += "  case ${COMP_WORDS[1]}:$previous in\n";
  for (const auto& command : commands)
    for (const auto& option : command.options)
      if (!option.words.empty())
        out += fmt::format("    {}:{}) COMPREPLY=($(compgen -W '{}' -- \"$current\")); return ;;\n",
                           command.name, option.name, fmt::join(option.words, " "));
  out +=
      "  esac\n  [[ $current == -* ]] || return  # files, by the shell itself\n  case ${COMP_WORDS[1]} in\n";
  for (const auto& command : commands)
    out += fmt::format("    {}) COMPREPLY=($(compgen -W '{}' -- \"$current\")) ;;\n", command.name,
                       options_of(command));
  return out + "  esac\n}\ncomplete -o default -F _superstep superstep\n";
}

std::string zsh_option(const OptionShape& option) {
  std::string meaning;
  for (const char c : option.meaning) meaning += c == '[' ? '(' : c == ']' ? ')' : c == ':' ? ',' : c;
  std::string spec = fmt::format("*{}[{}]", option.name, meaning);
  if (option.takes_value)
    spec += option.words.empty() ? ":value:_files" : fmt::format(":value:({})", fmt::join(option.words, " "));
  return quoted_for_shell(spec);
}

std::string zsh_script(std::span<const CommandShape> commands) {
  std::string out =
      "#compdef superstep\n# Load with: source <(superstep completion zsh)\n"
      "_superstep() {\n  local -a commands\n  commands=(\n";
  for (const auto& command : commands)
    out += fmt::format("    {}\n", quoted_for_shell(command.name + ":" + command.does));
  out +=
      "  )\n  if ((CURRENT == 2)); then\n    _describe command commands\n    return\n  fi\n  case "
      "${words[2]} in\n";
  for (const auto& command : commands) {
    out += fmt::format("    {})\n      _arguments '*:file:_files'", command.name);
    for (const auto& option : command.options) out += " \\\n        " + zsh_option(option);
    out += "\n      ;;\n";
  }
  return out + "  esac\n}\ncompdef _superstep superstep\n";
}

std::string fish_script(std::span<const CommandShape> commands) {
  std::string out = "# Load with: superstep completion fish | source\n";
  for (const auto& command : commands) {
    out += fmt::format("complete -c superstep -n __fish_use_subcommand -f -a {} -d {}\n", command.name,
                       quoted_for_shell(command.does));
    for (const auto& option : command.options) {
      out += fmt::format("complete -c superstep -n '__fish_seen_subcommand_from {}' -l {} -d {}",
                         command.name, option.name.substr(2), quoted_for_shell(option.meaning));
      if (option.takes_value)
        out += option.words.empty() ? " -r" : fmt::format(" -x -a '{}'", fmt::join(option.words, " "));
      out += "\n";
    }
  }
  return out;
}

}  // namespace

std::string completion_script(const std::string& shell, std::span<const CommandShape> commands) {
  if (shell == "bash") return bash_script(commands);
  if (shell == "zsh") return zsh_script(commands);
  if (shell == "fish") return fish_script(commands);
  const std::vector<std::string> shells = {"bash", "zsh", "fish"};
  throw UsageError(
      fmt::format("completion: unknown shell {}{}", in_quotes(shell), suggestion(shell, shells)));
}

}  // namespace superstep
