/// superstep info: the health of a case's network, without integrating it.

#include "bench/app/cli/command_entry.hpp"
#include "bench/app/commands.hpp"
#include "case/checks/health.hpp"
#include "integrators/press/sintering_case.hpp"
#include "reports/text/health_report.hpp"

namespace superstep {

namespace {

Command from_line(const Arguments& values) {
  return InfoCommand{common_options(values), single_case(values, "info")};
}

}  // namespace

int execute(const InfoCommand& command) {
  if (dynamics::is_sintering_case(command.case_file)) return info_sintering(command);
  const Scene scene = load_scene(command.case_file);
  const NetworkHealth health = assess_network(scene);
  print_data(command.common.json ? health_json(scene, health) : health_text(scene, health));
  return 0;
}

CommandEntry info_command() {
  return {.name = "info",
          .does = "health of a case's network, without integrating it",
          .examples =
              "  superstep info cases/nial_thermal.toml\n"
              "  superstep info cases/nial_thermal.toml --json",
          .positional = "CASE",
          .positional_meaning = "case file (TOML)",
          .options = {},
          .make = from_line};
}

}  // namespace superstep
