#include "bench/app/cli/cli_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <type_traits>
#include <variant>

#include "bench/host/machine.hpp"
#include "core/error.hpp"
#include "core/text/suggest.hpp"
#include "core/text/text_file.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

constexpr const char* end_of_options = "--";  // what follows is no option, whatever it begins with

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* option : app.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// Unknown arguments are collected by CLI11 and judged here, so that the message can name what was meant.
void reject_unknown_arguments(const CLI::App& app) {
  for (const auto& argument : app.remaining()) {
    if (argument == end_of_options) continue;
    const bool option = argument.starts_with("-");
    const std::string name = argument.substr(0, argument.find('='));
    if (option)
      throw UsageError(fmt::format("unknown option {}{}", superstep::in_quotes(name),
                                   suggestion(name, names_of_options(app))));
    if (app.get_parent() == nullptr)
      throw UsageError(fmt::format("unknown command {}{}", superstep::in_quotes(name),
                                   suggestion(name, names_of_commands(app))));
    throw UsageError(fmt::format("{}: unexpected argument {}; see superstep {} --help", app.get_name(),
                                 superstep::in_quotes(argument), app.get_name()));
  }
}

void add_common(CLI::App& app, Arguments& values) {
  app.add_option("--threads", values.threads, "threads that may compute (default 1)")->type_name("N");
  app.add_flag("--quiet", values.quiet, "no progress, notes or warnings on stderr");
  app.add_flag("--json", values.json, "machine-readable output on stdout");
  app.add_option("--block-rows", values.block_rows,
                 "rows that processes share out together, a multiple of 8 (default 32768, or 8192 for fields "
                 "of 32769 to 524287 rows); see lib/parallel")
      ->type_name("N");
  app.add_option("--color", values.color, "colours on stdout: auto, always or never (default auto)")
      ->type_name("WHEN");
}

void add_option(CLI::App& command, const OptionEntry& option, Arguments& values) {
  const auto add = [&](auto member) {
    using Value = std::remove_reference_t<decltype(values.*member)>;
    if constexpr (std::is_same_v<Value, bool>) {
      command.add_flag(option.name, values.*member, option.meaning);
    } else {
      auto* added = command.add_option(option.name, values.*member, option.meaning)->type_name(option.type);
      // A list takes one value per mention: `with_lists_spelt_out` has taken it apart.
      if constexpr (std::is_same_v<Value, std::vector<std::string>>) added->allow_extra_args(false);
    }
  };
  std::visit(add, option.target);
}

/// How many positional arguments a command takes as its usage and its list of them say it: one CASE, DIR...,
/// or [CASE...] where it does without. The parser itself takes any number, so that commands can say what is
/// wrong.
class CountedPositionals : public CLI::Formatter {
 public:
  explicit CountedPositionals(PositionalCount takes) : takes_(takes) {}

  std::string make_option_usage(const CLI::Option* option) const override {
    const std::string name = make_option_name(option, true);
    if (many()) return fmt::format(fmt::runtime(takes_.least == 0 ? "[{}...]" : "{}..."), name);
    std::string out = name;
    for (std::size_t k = 1; k < takes_.most; ++k) out += " " + name;
    return out;
  }
  std::string make_option_opts(const CLI::Option* option) const override {
    if (!option->get_positional()) return CLI::Formatter::make_option_opts(option);
    return many() ? " ..." : "";
  }

 private:
  [[nodiscard]] bool many() const noexcept { return takes_.most == 0; }

  PositionalCount takes_;
};

void add_command(CLI::App& app, const CommandEntry& entry, Arguments& values) {
  CLI::App& command = *app.add_subcommand(entry.name, entry.does);
  command.allow_extras();
  command.formatter(std::make_shared<CountedPositionals>(entry.takes));
  command.footer("Examples:\n" + entry.examples);
  add_common(command, values);
  if (!entry.positional.empty())
    command.add_option(entry.positional, values.cases, entry.positional_meaning)->type_name("");
  for (const auto& option : entry.options) add_option(command, option, values);
}

// An empty value is a slip, such as an unset shell variable; taking it as "not given" would hide that.
void reject_empty_values(const CLI::App& command) {
  for (const auto* option : command.get_options())
    for (const auto& value : option->results())
      if (value.empty()) throw UsageError(fmt::format("{}: the value is empty", option->get_name()));
}

std::string version_text() {
  const std::string revision = program_revision();
  return fmt::format("superstep {}{}\n", program_version(), revision.empty() ? "" : " (" + revision + ")");
}

void add_commands(CLI::App& app, Arguments& values) {
  for (const auto& entry : command_entries()) add_command(app, entry, values);
}

/// Names of options that take a list.
std::vector<std::string> names_of_lists() {
  std::vector<std::string> names;
  for (const auto& entry : command_entries())
    for (const auto& option : entry.options)
      if (std::holds_alternative<std::vector<std::string> Arguments::*>(option.target))
        names.push_back(option.name);
  return names;
}

/// A case file among SPECs: no integrator is called like a path, and what is a file on disk is meant as one.
bool is_case_file(const std::string& word) {
  const std::string name = word.substr(0, word.find(':'));
  const auto known = integrators();
  const bool is_method =
      std::any_of(known.begin(), known.end(), [&](const auto& entry) { return entry.name == name; });
  std::error_code none;
  return !is_method &&
         (name.find_first_of("./") != std::string::npos || std::filesystem::is_regular_file(word, none));
}

/// What is meant where an option stands without its value; empty = nothing.
std::string implied_value(const std::string& name) {
  for (const auto& entry : command_entries())
    for (const auto& option : entry.options)
      if (option.name == name) return option.implied;
  return {};
}

/// "--integrator A B" as "--integrator A --integrator B": a list ends at the next option or case file.
std::vector<std::string> with_lists_spelt_out(const std::vector<std::string>& line) {
  const auto lists = names_of_lists();
  std::vector<std::string> out;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k] == end_of_options) {
      out.insert(out.end(), line.begin() + static_cast<std::ptrdiff_t>(k), line.end());
      break;
    }
    out.push_back(line[k]);
    const std::string name = line[k].substr(0, line[k].find('='));
    const bool bare = name == line[k] && (k + 1 == line.size() || line[k + 1].starts_with("-"));
    if (const std::string implied = bare ? implied_value(name) : ""; !implied.empty()) out.push_back(implied);
    if (std::find(lists.begin(), lists.end(), name) == lists.end()) continue;
    if (name == line[k] && k + 1 < line.size()) out.push_back(line[++k]);
    for (; k + 1 < line.size() && !line[k + 1].starts_with("-") && !is_case_file(line[k + 1]); ++k) {
      out.push_back(name);
      out.push_back(line[k + 1]);
    }
  }
  return out;
}

const CLI::App& command_of(const CLI::App& app, const std::vector<std::string>& line) {
  for (const auto* command : app.get_subcommands(nullptr))
    if (!line.empty() && command->get_name() == line.front()) return *command;
  return app;
}

/// "--out", "-o" or "--", and no number below zero.
bool is_option(const std::string& word) {
  return word.starts_with("--") ||
         (word.size() > 1 && word[0] == '-' && std::isalpha(static_cast<unsigned char>(word[1])) != 0);
}

/// The parser would take the option that follows for the value.
void require_values(const CLI::App& command, const std::vector<std::string>& line) {
  for (std::size_t k = 0; k < line.size() && line[k] != end_of_options; ++k) {
    if (line[k].starts_with("--") && line[k].ends_with('='))
      throw UsageError(fmt::format("{} is followed by nothing; give it a value", line[k]));
    if (!is_option(line[k]) || (k + 1 < line.size() && !is_option(line[k + 1]))) continue;
    const auto* option = command.get_option_no_throw(line[k]);
    if (option && option->get_items_expected_min() > 0)
      throw UsageError(fmt::format("{0} needs a value: {0} {1} ({2})", line[k], option->get_type_name(),
                                   option->get_description()));
  }
}

}  // namespace

Arguments read_arguments(const std::vector<std::string>& written) {
  const auto line = with_lists_spelt_out(written);
  CLI::App app("Superstep: which time integrator is fastest for heat and current in packings of particles?",
               "superstep");
  app.require_subcommand(0, 1);
  app.allow_extras();
  app.footer("Each command has its own --help with examples.");
  Arguments values;
  bool version = false;
  app.add_flag("--version", version, "print the version");
  add_common(app, values);
  add_commands(app, values);
  require_values(command_of(app, line), line);
  try {
    app.parse(std::vector<std::string>(line.rbegin(), line.rend()));  // CLI11 takes them from the back
  } catch (const CLI::CallForHelp&) {
    values.text = app.help();
    return values;
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string what = error.what();
    throw UsageError(what.substr(0, what.find(':')) + " stands more than once; give it once");
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  if (version) {
    values.text = version_text();
    return values;
  }
  reject_unknown_arguments(app);
  const auto chosen = app.get_subcommands();
  if (chosen.empty())
    throw UsageError(
        fmt::format("a command is missing{}; see superstep --help", suggestion("", names_of_commands(app))));
  reject_unknown_arguments(*chosen.front());
  reject_empty_values(*chosen.front());
  values.command = chosen.front()->get_name();
  return values;
}

std::vector<CommandShape> command_shapes() {
  CLI::App app;
  Arguments values;
  add_commands(app, values);
  std::vector<CommandShape> shapes;
  for (const auto* command : app.get_subcommands(nullptr)) {
    CommandShape shape{.name = command->get_name(), .does = command->get_description(), .options = {}};
    for (const auto* option : command->get_options())
      for (const auto& name : option->get_lnames())
        shape.options.push_back(
            {.name = "--" + name,
             .meaning = option->get_description(),
             .takes_value = option->get_expected_max() > 0 && option->get_items_expected_max() > 0,
             .words = {}});
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

}  // namespace superstep
