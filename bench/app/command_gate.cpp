/// superstep gate and superstep compare: results against a recorded baseline, and against each other.

#include <fmt/format.h>

#include "bench/app/cli/command_entry.hpp"
#include "bench/app/commands.hpp"
#include "core/error.hpp"
#include "integrators/registry.hpp"
#include "reports/gate/compare.hpp"
#include "reports/gate/gate.hpp"

namespace superstep {
namespace {

/// A method that this build does not know counts as one with fixed steps: its work must be exact.
bool is_adaptive(const std::string& name) {
  for (const auto& entry : integrators())
    if (entry.name == name) return entry.adaptive;
  return false;
}

Command gate_from_line(const Arguments& values) {
  if (values.cases.size() != 1)
    throw UsageError("gate: give one results.json, or the folder that holds it; see superstep gate --help");
  if (values.baseline.empty())
    throw UsageError("gate: --baseline FILE is missing; see superstep gate --help");
  return GateCommand{common_options(values), values.cases.front(), values.baseline};
}

Command compare_from_line(const Arguments& values) {
  if (values.cases.size() != 2)
    throw UsageError(
        "compare: give two results.json or folders that hold them; see superstep compare --help");
  if (values.json) throw UsageError("compare: writes a Markdown table; leave --json out");
  return CompareCommand{common_options(values), values.cases[0], values.cases[1]};
}

}  // namespace

int execute(const GateCommand& command) {
  const auto report = judge(read_results(command.results), read_results(command.baseline), is_adaptive);
  print_data(command.common.json ? gate_json(report) : gate_markdown(report));
  switch (report.verdict) {
    case GateVerdict::regressed:
      return static_cast<int>(ExitCode::regressed);
    case GateVerdict::inconclusive:
      return static_cast<int>(ExitCode::inconclusive);
    default:
      return static_cast<int>(ExitCode::ok);
  }
}

int execute(const CompareCommand& command) {
  const auto a = read_results(command.a), b = read_results(command.b);
  const auto rows = compare(a, b);
  print_data(compare_markdown(a, b, rows));
  return static_cast<int>(rows.empty() ? ExitCode::inconclusive : ExitCode::ok);
}

CommandEntry gate_command() {
  return {.name = "gate",
          .does = "is this build as good as a recorded one? exit 0 yes, 5 no, 6 cannot tell",
          .examples =
              "  superstep bench cases/nial_thermal.toml --repetitions 11 --out result\n"
              "  superstep gate result --baseline reports/baselines/nial_thermal.json",
          .positional = "RESULTS",
          .positional_meaning = "results.json of superstep bench, or its folder",
          .options = {{"--baseline", &Arguments::baseline, "the recorded results.json", "FILE"}},
          .make = gate_from_line};
}

CommandEntry compare_command() {
  return {.name = "compare",
          .does = "two sets of results side by side, with intervals",
          .examples = "  superstep compare before after",
          .positional = "RESULTS",
          .positional_meaning = "results.json of superstep bench, or their folders",
          .options = {},
          .make = compare_from_line};
}

}  // namespace superstep
