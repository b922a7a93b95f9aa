/// superstep fit: the constants that `auto` chooses by, from the points of a corpus.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <set>
#include <utility>

#include "bench/app/cli/command_entry.hpp"
#include "bench/app/commands.hpp"
#include "bench/harness/corpus/cost_fit.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/text/quantity.hpp"
#include "results/corpus/corpus_csv.hpp"
#include "results/text/plain_table.hpp"

namespace superstep {
namespace {

Command fit_from_line(const Arguments& values) {
  if (values.cases.empty())
    throw UsageError(
        "fit: give corpus.csv of superstep bench --corpus, or several; see superstep fit --help");
  if (values.json) throw UsageError("fit: writes tables and a header; leave --json out");
  return FitCommand{common_options(values), values.cases, values.out};
}

std::string today() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  gmtime_r(&now, &parts);
  return fmt::format("{:04}-{:02}-{:02}", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday);
}

std::string joined(const std::set<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Machine, revision, date, command and number of points.
std::vector<std::string> origin_of(const FitCommand& command, std::span<const CostPoint> points) {
  std::set<std::string> processors, revisions, scenes;
  for (const auto& point : points) {
    processors.insert(point.row->processor);
    revisions.insert(point.row->revision);
    scenes.insert(point.row->scene);
  }
  return {fmt::format("{} of {}; {}; revision {}; {};", quantity(points.size(), "point"),
                      quantity(scenes.size(), "scene"), joined(processors), joined(revisions), today()),
          fmt::format("superstep fit {}", fmt::join(command.files, " "))};
}

PlainTable quality_table(std::span<const CostPoint> points, const CostConstants& constants) {
  PlainTable table{
      .id = "fit-quality",
      .title = "How well costs are predicted",
      .intro = "Predicted over measured CPU time, either way: the middle point and the worst one.",
      .headers = {"family", "points", "middle", "worst"}};
  for (const auto& one : fit_quality(points, constants)) {
    table.rows.push_back({{family_spec(one.family, Physics::linear)},
                          {fmt::format("{}", one.points)},
                          {fmt::format("{:.2f}x", one.median)},
                          {fmt::format("{:.1f}x", one.worst)}});
  }
  return table;
}

PlainTable held_out_table(std::span<const HeldOut> choices) {
  const auto close =
      std::count_if(choices.begin(), choices.end(), [](const auto& one) { return one.within(1.3); });
  const auto beyond =
      std::count_if(choices.begin(), choices.end(), [](const auto& one) { return !one.within(2); });
  PlainTable table{
      .id = "fit-held-out",
      .title = "What auto would choose where it has not seen the class of the scene",
      .intro = fmt::format(
          "CPU of the choice over that of the best that met the tolerance: within 1.3 in {} of {} ({:.0f} "
          "%), beyond 2 in {}; where the best takes less than 5 ms, 2 ms more are within. Between the "
          "points of a ladder times are interpolated.",
          close, choices.size(), 100.0 * static_cast<double>(close) / static_cast<double>(choices.size()),
          beyond),
      .headers = {"scene", "class", "error", "choice", "CPU [s]", "best", "CPU [s]", "regret", ""}};
  for (const auto& one : choices) {
    const bool late = !one.within(2);
    table.rows.push_back({{one.facts->scene},
                          {one.facts->scene_class},
                          {fmt::format("{:.0e}", one.rtol)},
                          {one.spec},
                          {one.cpu ? fmt::format("{:.3g}", *one.cpu) : "-"},
                          {one.best->spec},
                          {fmt::format("{:.3g}", *one.best->cpu)},
                          {fmt::format("{:.2f}", one.ratio()), late ? "bad" : ""},
                          {late                                 ? "beyond 2"
                           : !one.within(1.3)                   ? "beyond 1.3"
                           : one.error && *one.error > one.rtol ? "errs more"
                                                                : "",
                           "dim"}});
  }
  return table;
}

/// The rows of all files. A measurement that stands in several of them counts once.
std::vector<CorpusRow> rows_of(const FitCommand& command) {
  std::vector<CorpusRow> rows;
  std::set<std::string> seen;
  std::size_t again = 0;
  for (const auto& file : command.files)
    for (auto& row : read_corpus_csv(file)) {
      if (seen.insert(corpus_csv({&row, 1})).second)
        rows.push_back(std::move(row));
      else
        ++again;
    }
  if (again > 0 && !command.common.quiet)
    note(fmt::format("fit: {} in the files more than once; each measurement counts once",
                     quantity(again, "row stands", "rows stand")));
  return rows;
}

}  // namespace

int execute(const FitCommand& command) {
  const auto rows = rows_of(command);
  const auto points = cost_points(rows);
  if (points.empty()) {
    note(
        "fit: no row is of a method whose cost is modelled; it needs a corpus.csv of this version, measured "
        "on "
        "one thread, with methods among which auto chooses");
    return static_cast<int>(ExitCode::inconclusive);
  }
  const CostConstants constants = fit_costs(points);
  const bool color = use_color(command.common.color);
  print_data(terminal_text(quality_table(points, constants), color));
  const auto choices = held_out_choices(rows, points);
  if (!choices.empty()) print_data("\n" + terminal_text(held_out_table(choices), color));
  if (command.header.empty()) return 0;
  write_file_atomically(command.header, constants_header(constants, origin_of(command, points)));
  if (!command.common.quiet) note("constants in " + command.header);
  return 0;
}

CommandEntry fit_command() {
  return {
      .name = "fit",
      .does =
          "the constants that auto chooses by, from a corpus; what it would choose on classes it has not "
          "seen",
      .examples =
          "  superstep bench --corpus quick --out quick\n"
          "  superstep fit quick/corpus.csv\n"
          "  superstep fit quick/corpus.csv --out integrators/costs/fitted_constants.hpp",
      .positional = "CORPUS.csv",
      .positional_meaning = "corpus.csv of superstep bench --corpus, or several",
      .options = {{"--out", &Arguments::out, "write the constants as a header that the build takes", "FILE"}},
      .takes = {.least = 1, .most = 0},
      .make = fit_from_line};
}

}  // namespace superstep
