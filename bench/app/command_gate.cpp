/// superstep gate and superstep compare: results against a recorded baseline, and against each other.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "bench/app/cli/command_entry.hpp"
#include "bench/app/commands.hpp"
#include "core/error.hpp"
#include "integrators/registry.hpp"
#include "reports/gate/compare.hpp"
#include "reports/gate/gate.hpp"
#include "results/corpus/corpus_cells.hpp"
#include "results/corpus/corpus_csv.hpp"

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

/// corpus.csv in a folder without results.json, or that file itself; empty = it is none.
std::string corpus_file(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path inside = fs::path(path) / "corpus.csv";
  if (fs::is_regular_file(inside, none) && !fs::exists(fs::path(path) / "results.json", none))
    return inside.string();
  return fs::path(path).extension() == ".csv" && fs::is_regular_file(path, none) ? path : "";
}

/// Scenes of `here` that are not among those of `there`.
std::vector<std::string> only_in(const std::vector<SceneRows>& here, const std::vector<SceneRows>& there) {
  std::vector<std::string> names;
  for (const auto& one : here)
    if (std::none_of(there.begin(), there.end(),
                     [&](const auto& other) { return other.facts->scene == one.facts->scene; }))
      names.push_back(one.facts->scene);
  return names;
}

/// Do two measurements of a corpus name the same winners?
int compare_corpora(const std::string& a, const std::string& b) {
  const auto rows_a = read_corpus_csv(a), rows_b = read_corpus_csv(b);
  const auto scenes_a = scenes_of(rows_a), scenes_b = scenes_of(rows_b);
  const CellAgreement found = agreement(corpus_cells(scenes_a), corpus_cells(scenes_b));
  std::string out = fmt::format(
      "{} cells of scene and error: {} have the same winner, in {} one of the two can not tell, {} differ\n",
      found.cells, found.same, found.untold, found.different);
  for (const auto& one : found.differences) out += fmt::format("- {}\n", one);
  for (const auto& [name, here, there] :
       {std::tuple("A", &scenes_a, &scenes_b), std::tuple("B", &scenes_b, &scenes_a)})
    if (const auto names = only_in(*here, *there); !names.empty())
      out += fmt::format("only in {}: {}\n", name, fmt::join(names, ", "));
  print_data(out);
  return static_cast<int>(found.cells > 0 ? ExitCode::ok : ExitCode::inconclusive);
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
  const std::string corpus_a = corpus_file(command.a), corpus_b = corpus_file(command.b);
  if (!corpus_a.empty() && !corpus_b.empty()) return compare_corpora(corpus_a, corpus_b);
  const auto a = read_results(command.a), b = read_results(command.b);
  const auto rows = compare(a, b);
  print_data(compare_markdown(a, b, rows));
  return static_cast<int>(rows.empty() ? ExitCode::inconclusive : ExitCode::ok);
}

CommandEntry gate_command() {
  return {.name = "gate",
          .does = "is this build as good as a recorded one? exit 0 yes, 5 no, 6 cannot tell",
          .examples =
              "  superstep bench cases/nial_thermal.toml --integrator rkc sts:n=20,nu=1e-3 --repetitions 11 "
              "--out "
              "result\n"
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
          .positional_meaning = "results.json of superstep bench, or their folders; or two of bench --corpus",
          .options = {},
          .takes = {.least = 2, .most = 2},
          .make = compare_from_line};
}

}  // namespace superstep
