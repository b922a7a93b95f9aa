/// superstep gate and superstep compare: results against a recorded baseline, and against each other.

#include <fmt/format.h>

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

}  // namespace superstep
