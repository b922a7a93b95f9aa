/// superstep info: the health of a case's network, without integrating it; or what a packing or network file
/// is.

#include <fmt/format.h>

#include <array>

#include "bench/app/cli/command_entry.hpp"
#include "bench/app/commands.hpp"
#include "bench/app/file_report.hpp"
#include "bench/app/loaded_case.hpp"
#include "bench/app/press/press_commands.hpp"
#include "bench/host/terminal.hpp"
#include "bench/output/system_files.hpp"
#include "case/case.hpp"
#include "case/checks/health.hpp"
#include "core/error.hpp"
#include "reports/text/health_report.hpp"

namespace superstep {

namespace {

Command info_from_line(const Arguments& values) {
  return InfoCommand{common_options(values), single_case(values, "info", "a case, packing or network file"),
                     file_options_of(values), values.matrix};
}

int info(const InfoCommand& command, const Scene& scene) {
  if (!command.matrix.empty()) {
    const auto warnings = write_system(command.matrix, scene);
    if (!command.common.quiet) warn(warnings);
  }
  const NetworkHealth health = assess_network(scene);
  print_data(command.common.json ? health_json(scene, health) : health_text(scene, health));
  return 0;
}

int info(const InfoCommand& command, const Press& press) {
  refuse_for_moving("info", std::array{GivenOption{!command.matrix.empty(), "--matrix"}}, press.file);
  return info_press(command, press);
}

}  // namespace

int execute(const InfoCommand& command) {
  if (is_no_case(command.case_file)) {
    if (!command.matrix.empty())
      throw UsageError("info: --matrix needs a case, which has capacities and fixed values");
    print_data(file_report(command));
    return 0;
  }
  if (!command.file.given.empty())
    throw UsageError(fmt::format(
        "info: {} is about a packing file, and {} is a case, which says such things itself; leave "
        "it out, or give the packing",
        command.file.given.front(), command.case_file));
  return std::visit([&](const auto& one) { return info(command, one); },
                    load_case_watched(parse_case(command.case_file), command.common.quiet));
}

CommandEntry info_command() {
  auto options = file_options();
  options.push_back({"--matrix", &Arguments::matrix,
                     "write the case's system in the Matrix Market's format, with a case that reads it back",
                     "FOLDER"});
  return {.name = "info",
          .does = "health of a case's network, or what a packing or network file is",
          .examples =
              "  superstep info cases/nial_thermal.toml\n"
              "  superstep info cases/nial_thermal.toml --json\n"
              "  superstep info packing.dump --conductivity 85 --density 5910 --axis z\n"
              "  superstep info cases/chain.toml --matrix system",
          .positional = "CASE",
          .positional_meaning = "case file (TOML), packing file or network file",
          .options = std::move(options),
          .make = info_from_line};
}

}  // namespace superstep
