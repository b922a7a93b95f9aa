/// superstep report: one HTML file from a folder of results.

#include <fmt/format.h>

#include "bench/commands.hpp"
#include "bench/report_file.hpp"
#include "core/error.hpp"

namespace superstep {

int execute(const ReportCommand& command) {
  const std::string file = write_report(command.folder);
  if (!command.common.quiet) note("report in " + file);
  return static_cast<int>(ExitCode::ok);
}

}  // namespace superstep
