/// superstep info: the health of a case's network, without integrating it.

#include "bench/app/cli/command_entry.hpp"
#include "bench/app/commands.hpp"
#include "bench/app/press/press_commands.hpp"
#include "case/case.hpp"
#include "case/checks/health.hpp"
#include "reports/text/health_report.hpp"

namespace superstep {

namespace {

Command from_line(const Arguments& values) {
  return InfoCommand{common_options(values), single_case(values, "info")};
}

int info(const InfoCommand& command, const Scene& scene) {
  const NetworkHealth health = assess_network(scene);
  print_data(command.common.json ? health_json(scene, health) : health_text(scene, health));
  return 0;
}

int info(const InfoCommand& command, const Press& press) {
  return info_press(command, press);
}

}  // namespace

int execute(const InfoCommand& command) {
  return std::visit([&](const auto& one) { return info(command, one); }, load_case(command.case_file));
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
