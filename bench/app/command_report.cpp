/// superstep report: one HTML file from a folder of results.

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "bench/app/cli/command_entry.hpp"
#include "bench/app/commands.hpp"
#include "bench/app/report_file.hpp"
#include "core/error.hpp"
#include "reports/text/markdown_summary.hpp"
#include "results/results_json.hpp"
#include "results/text/json_object.hpp"

namespace superstep {
namespace {

std::string summary(const ReportCommand& command) {
  const BenchReport report = read_results_json(command.folder + "/results.json");
  std::optional<BenchReport> before;
  if (!command.against.empty()) before = read_results_json(command.against + "/results.json");
  return markdown_summary(report, before ? &*before : nullptr);
}

std::string report_json(const std::string& file) {
  const nlohmann::ordered_json json = {{"schema", "superstep.report"}, {"schema_version", 1}, {"file", file}};
  return json_text(json);
}

Command report_from_line(const Arguments& values) {
  if (values.cases.empty())
    throw UsageError("report: a folder of results is missing; see superstep report --help");
  if (!values.against.empty() && !values.markdown)
    throw UsageError("report: --against goes with --markdown; add that, or leave it out");
  if (values.markdown && values.json)
    throw UsageError("report: --markdown and --json both want stdout; choose one");
  return ReportCommand{.common = common_options(values),
                       .folder = single_case(values, "report", "a folder of results"),
                       .markdown = values.markdown,
                       .against = values.against};
}

}  // namespace

int execute(const ReportCommand& command) {
  const std::string markdown = command.markdown ? summary(command) : std::string();
  const std::string file = write_report(command.folder);
  if (command.common.json)
    print_data(report_json(file));
  else
    print_data(markdown);
  if (!command.common.quiet) note("report in " + file);
  return static_cast<int>(ExitCode::ok);
}

CommandEntry report_command() {
  return {.name = "report",
          .does = "one HTML file from the results of bench, run and stability",
          .examples =
              "  superstep report reports/out/nial_thermal\n"
              "  superstep bench cases/nial_thermal.toml --out result && superstep report result\n"
              "  superstep report result --markdown --against earlier",
          .positional = "DIR",
          .positional_meaning = "folder that bench, run or stability wrote",
          .options = {{"--markdown", &Arguments::markdown,
                       "print a summary for continuous integration as well", ""},
                      {"--against", &Arguments::against,
                       "with --markdown: list only what changed since that benchmark", "DIR"}},
          .make = report_from_line};
}

}  // namespace superstep
