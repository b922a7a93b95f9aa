/// superstep init: a commented case for a packing file.

#include <fmt/format.h>

#include <filesystem>

#include "bench/app/cli/command_entry.hpp"
#include "bench/app/commands.hpp"
#include "bench/app/file_report.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "packing/read.hpp"

namespace superstep {
namespace {

namespace fs = std::filesystem;

Command init_from_line(const Arguments& values) {
  if (values.json) throw UsageError("init: writes a case and prints nothing; leave --json out");
  InitCommand command{.common = common_options(values),
                      .packing_file = single_case(values, "init", "a packing file"),
                      .case_file = values.file,
                      .file = file_options_of(values)};
  if (command.case_file.empty()) throw UsageError("init: -o FILE is missing; see superstep init --help");
  return command;
}

/// The packing as a case in another folder names it.
std::string name_beside(const std::string& packing, const std::string& case_file) {
  const fs::path folder = fs::absolute(case_file).lexically_normal().parent_path();
  const fs::path relative = fs::absolute(packing).lexically_normal().lexically_relative(folder);
  const bool is_near = !relative.empty() && relative.native().compare(0, 9, "../../../") != 0;
  return is_near ? relative.string() : fs::absolute(packing).string();
}

}  // namespace

int execute(const InitCommand& command) {
  if (fs::exists(command.case_file))
    throw UsageError(
        fmt::format("init: {} is there already; remove it, or choose another name", command.case_file));
  if (!is_no_case(command.packing_file))
    throw InputError(
        fmt::format("{0}: this is a case already; go on with superstep info {0} or superstep run {0}, or "
                    "give a packing file",
                    command.packing_file));
  const Packing packing = read_packing(command.packing_file, command.file.reading);
  StarterSettings settings = starter_settings(packing, command.file, command.packing_file);
  PackingConduction conduction = assess_conduction(packing, command.packing_file, settings);
  if (conduction.all_held) {
    settings.held_once = true;
    conduction = assess_conduction(packing, command.packing_file, settings);
  }
  settings.t_end = conduction.time;
  settings.file = name_beside(command.packing_file, command.case_file);
  write_file_atomically(command.case_file, starter_case(packing, settings));
  if (!command.common.quiet)
    note(fmt::format("case in {}; next: superstep info {}, superstep run {}", command.case_file,
                     command.case_file, command.case_file));
  return 0;
}

CommandEntry init_command() {
  auto options = file_options();
  options.push_back({"-o,--output", &Arguments::file, "case file to write", "FILE"});
  return {.name = "init",
          .does = "write a commented case for a packing file, to start from",
          .examples =
              "  superstep init packing.dump -o case.toml\n"
              "  superstep init packing.dump --conductivity 85 --density 5910 --axis z -o case.toml",
          .positional = "FILE",
          .positional_meaning = "packing file, in any format that is read",
          .options = std::move(options),
          .make = init_from_line};
}

}  // namespace superstep
