/// superstep report: one HTML file from a folder of results.

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "bench/app/commands.hpp"
#include "bench/app/report_file.hpp"
#include "core/error.hpp"
#include "reports/text/markdown_summary.hpp"
#include "results/read_results.hpp"

namespace superstep {
namespace {

std::string summary(const ReportCommand& command) {
  const BenchReport report = read_results_json(command.folder + "/results.json");
  std::optional<BenchReport> before;
  if (!command.against.empty()) before = read_results_json(command.against + "/results.json");
  return markdown_summary(report, before ? &*before : nullptr);
}

std::string json_text(const std::string& file) {
  const nlohmann::ordered_json json = {{"schema", "superstep.report"}, {"schema_version", 1}, {"file", file}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

int execute(const ReportCommand& command) {
  const std::string markdown = command.markdown ? summary(command) : std::string();
  const std::string file = write_report(command.folder);
  if (command.common.json)
    print_data(json_text(file));
  else
    print_data(markdown);
  if (!command.common.quiet) note("report in " + file);
  return static_cast<int>(ExitCode::ok);
}

}  // namespace superstep
