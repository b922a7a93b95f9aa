/// superstep info: the health of a case's network, without integrating it.

#include "bench/app/commands.hpp"
#include "case/checks/health.hpp"
#include "integrators/press/sintering_case.hpp"
#include "reports/text/health_report.hpp"

namespace superstep {

int execute(const InfoCommand& command) {
  if (dynamics::is_sintering_case(command.case_file)) return info_sintering(command);
  const Scene scene = load_scene(command.case_file);
  const NetworkHealth health = assess_network(scene);
  print_data(command.common.json ? health_json(scene, health) : health_text(scene, health));
  return 0;
}

}  // namespace superstep
