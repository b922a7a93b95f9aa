#include "results/corpus/corpus_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/text/quantity.hpp"
#include "results/corpus/corpus_summary.hpp"

namespace superstep {
namespace {

using Cell = PlainTable::Cell;

std::string factor_text(double factor) {
  return factor < 9.95 ? fmt::format("{:.1f}x", factor) : fmt::format("{:.0f}x", factor);
}

std::string level_text(double level) {
  return fmt::format("{:.0e}", level);
}

std::vector<std::string> with_levels(std::vector<std::string> headers) {
  for (const double level : corpus_levels()) headers.push_back("error " + level_text(level));
  return headers;
}

/// Fastest first: "rkc", or "rkc or rkl" where they can not be told apart.
Cell winner_cell(const CorpusCell& cell) {
  if (!cell.judged) return {"-", "dim", "the reference is not known well enough"};
  if (cell.entrants.empty()) return {"nobody", "dim", "no method reached the error within the time limit"};
  const auto seconds = [](const Entrant& one) { return fmt::format("{:.3g} s", *one.row->cpu); };
  const std::size_t tied = cell.tied();
  Cell out;
  for (std::size_t k = 0; k < cell.entrants.size(); ++k) {
    const Entrant& one = cell.entrants[k];
    out.hint += fmt::format("{}{} {}", k ? "; " : "", one.row->spec, seconds(one));
    if (k > 0)
      out.hint +=
          fmt::format(" ({:.2f}x, {:.2f} to {:.2f})", one.behind.estimate, one.behind.low, one.behind.high);
    if (k == 0 || (tied > 1 && !one.behind.clear())) out.text += (k ? " or " : "") + one.row->integrator;
  }
  if (tied > 1) return out;
  out.kind = "strong";
  out.text += cell.entrants.size() > 1 ? " " + factor_text(cell.entrants[1].behind.estimate) : " alone";
  return out;
}

PlainTable winners_table(std::span<const SceneRows> scenes, std::span<const CorpusCell> cells) {
  PlainTable table{.id = "winners",
                   .title = "The fastest method of every scene",
                   .intro =
                       "With its lead over the next method. \"or\": they can not be told apart, because the "
                       "lead is below 1.1 or not there in every round. Errors are rms over the span of the "
                       "field, the worst of fields and output times.",
                   .headers = with_levels({"scene", "class", "unknowns", "t rho"})};
  const std::size_t levels = corpus_levels().size();
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const CorpusRow& facts = *scenes[k].facts;
    std::vector<Cell> row = {{facts.scene},
                             {facts.scene_class},
                             {fmt::format("{}", facts.unknowns)},
                             {fmt::format("{:.1e}", facts.stiffness)}};
    for (std::size_t l = 0; l < levels; ++l) row.push_back(winner_cell(cells[levels * k + l]));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Cell map_cell(const MapCell& cell) {
  if (cell.cells == 0) return {"-", "dim"};
  const MethodScore& best = cell.methods.front();
  Cell out{fmt::format("{} {}", best.integrator, factor_text(best.factor)), "strong", {}};
  if (best.reached < cell.cells) out.text += fmt::format(" ({} of {})", best.reached, cell.cells);
  for (const auto& one : cell.methods)
    out.hint += fmt::format("{}{} {} in {} of {}", out.hint.empty() ? "" : "; ", one.integrator,
                            factor_text(one.factor), one.reached, cell.cells);
  return out;
}

PlainTable map_table(std::span<const CorpusCell> cells) {
  PlainTable table{
      .id = "map",
      .title = "Which method for which scenes",
      .intro =
          "The method that reaches the error in most scenes of a class or size, of those the fastest; how "
          "much slower than the best of each scene it is (geometric mean), and in how many scenes where "
          "not in all.",
      .headers = with_levels({"scenes"})};
  const auto map = corpus_map(cells);
  const std::size_t levels = corpus_levels().size();
  for (std::size_t k = 0; k < map.size(); k += levels) {
    const std::string name =
        map[k].size.empty() ? map[k].scene_class : fmt::format("about {} unknowns", map[k].size);
    std::vector<Cell> row = {{name}};
    for (std::size_t l = 0; l < levels; ++l) row.push_back(map_cell(map[k + l]));
    table.rows.push_back(std::move(row));
  }
  return table;
}

PlainTable profile_table(std::span<const CorpusCell> cells) {
  constexpr double factors[] = {1, 1.3, 2, 5, 10, 100};
  PlainTable table{.id = "profiles",
                   .title = "How often each method is how close to the best",
                   .intro =
                       "Part of all scenes and errors in which its CPU time is within a factor of that of "
                       "the best method (performance profile, Dolan & More 2002); the memory that it adds "
                       "(geometric mean).",
                   .headers = {"method"}};
  for (const double factor : factors) table.headers.push_back(fmt::format("{:g}x", factor));
  table.headers.insert(table.headers.end(), {"reaches", "won", "shared", "memory [MB]"});
  std::map<std::string, MethodScore> totals;
  std::map<std::string, double> memory;
  for (const auto& cell : corpus_map(cells))
    if (!cell.scene_class.empty())
      for (const auto& one : cell.methods) {
        MethodScore& sum = totals[one.integrator];
        sum.alone += one.alone;
        sum.shared += one.shared;
        sum.reached += one.reached;
        memory[one.integrator] += one.memory * static_cast<double>(one.reached);
      }
  for (const auto& profile : corpus_profiles(cells)) {
    std::vector<Cell> row = {{profile.integrator, "strong"}};
    const auto percent = [](double part) { return fmt::format("{:.0f} %", 100 * part); };
    for (const double factor : factors) row.push_back({percent(profile.within(factor))});
    const MethodScore& sum = totals[profile.integrator];
    row.push_back({percent(static_cast<double>(profile.ratios.size()) / static_cast<double>(profile.cells))});
    row.push_back({fmt::format("{}", sum.alone)});
    row.push_back({fmt::format("{}", sum.shared)});
    row.push_back({fmt::format("{:.2g}", memory[profile.integrator] / static_cast<double>(sum.reached))});
    table.rows.push_back(std::move(row));
  }
  return table;
}

PlainTable regret_table(std::span<const SceneRows> scenes) {
  const auto regrets = regrets_of(scenes);
  const RegretSummary sum = summarize(regrets);
  PlainTable table{
      .id = "auto",
      .title = "What auto costs beside the best method",
      .intro = "",
      .headers = {"scene", "rtol", "auto [s]", "chose", "best", "best [s]", "ratio", "delivered"}};
  if (regrets.empty()) return table;
  table.intro = fmt::format(
      "CPU time of auto, preparation included, over that of the cheapest SPEC whose error is within auto's "
      "tolerance. Within 1.3 (or 2 ms where the best takes less than 5 ms) in {} of {}, {}; its tolerance "
      "kept "
      "in {}.",
      sum.close, sum.count,
      sum.never_beyond ? "never beyond 2 (or those 2 ms)"
                       : fmt::format("beyond 2 in some, up to {}", factor_text(sum.worst)),
      sum.kept);
  for (const auto& regret : regrets) {
    const CorpusRow& row = *regret.row;
    const std::string kind = !row.ok() || !regret.within(2) ? "bad" : regret.within(1.3) ? "good" : "";
    table.rows.push_back(
        {{row.scene},
         {level_text(regret.rtol)},
         {row.cpu ? fmt::format("{:.3g}", *row.cpu) : row.status, row.ok() ? "" : "bad", row.reason},
         {row.choice.substr(0, row.choice.find_first_of(",:")), "", row.choice},
         {regret.best ? regret.best->spec : "nobody"},
         {regret.best ? fmt::format("{:.3g}", *regret.best->cpu) : ""},
         {regret.ratio > 0 ? fmt::format("{:.2f}", regret.ratio) : "", kind},
         {row.ok() ? fmt::format("{:.2g}", regret.delivered) : "", regret.delivered > 1 ? "bad" : ""}});
  }
  return table;
}

/// Reasons without their numbers, so that the same ones fall together.
std::string kind_of(const std::string& reason) {
  std::string out;
  for (const char c : reason)
    if (c >= '0' && c <= '9') {
      if (!out.ends_with('#')) out += '#';
    } else {
      out += c;
    }
  return out;
}

PlainTable failures_table(std::span<const CorpusRow> rows) {
  PlainTable table{.id = "failures",
                   .title = "What failed, and why",
                   .intro = "Points that did not end well, by method, status and reason (one of each).",
                   .headers = {"method", "status", "points", "scenes", "as in", "reason"}};
  for (const auto& tally : corpus_tallies(rows)) {
    std::map<std::pair<std::string, std::string>, std::vector<const CorpusRow*>> kinds;
    for (const CorpusRow* row : tally.others) kinds[{row->status, kind_of(row->reason)}].push_back(row);
    for (const auto& [kind, points] : kinds) {
      std::set<std::string> names;
      for (const CorpusRow* row : points) names.insert(row->scene);
      const CorpusRow& first = *points.front();
      table.rows.push_back({{tally.integrator},
                            {first.status, "bad"},
                            {fmt::format("{} of {}", points.size(), tally.points)},
                            {fmt::format("{}", names.size())},
                            {fmt::format("{} on {}", first.spec, first.scene)},
                            {first.reason}});
    }
  }
  return table;
}

/// Points by what became of them, each kind with its reason to be.
std::string points_text(std::span<const CorpusRow> rows) {
  std::size_t ok = 0, slow = 0;
  for (const auto& row : rows) {
    ok += row.ok() ? 1 : 0;
    slow += row.status == "timeout" ? 1 : 0;
  }
  std::string out = fmt::format("{}: {} done", quantity(rows.size(), "point"), ok);
  if (slow > 0) out += fmt::format(", {} stopped because others had long been faster", slow);
  if (const std::size_t rest = rows.size() - ok - slow; rest > 0)
    out += fmt::format(", {} refused or not good enough", rest);
  return out;
}

std::string percent(double part) {
  return fmt::format("{:.0f} %", 100 * part);
}

/// The method that is best most often, and how close `auto` comes.
std::string winner_text(std::span<const CorpusCell> cells) {
  constexpr double as_good = 1.05, close = 1.3;
  const auto profiles = corpus_profiles(cells);
  const Profile *winner = nullptr, *chooser = nullptr;
  for (const auto& profile : profiles) {
    const bool chooses = profile.integrator == "auto";
    if (chooses) chooser = &profile;
    if (!chooses && (!winner || profile.within(as_good) > winner->within(as_good))) winner = &profile;
  }
  if (!winner) return {};
  std::string out = fmt::format(
      "{} is fastest, or within {:.0f} % of it, for {} of the {} pairs of a scene "
      "and an error",
      winner->integrator, 100 * (as_good - 1), percent(winner->within(as_good)), winner->cells);
  if (chooser)
    out += fmt::format("; auto, which chooses by itself, takes at most {:g} times the least for {}", close,
                       percent(chooser->within(close)));
  return out + ". ";
}

}  // namespace

std::string corpus_headline(std::span<const CorpusRow> rows) {
  if (rows.empty()) return "nothing was measured";
  const auto scenes = scenes_of(rows);
  const CorpusRow& first = rows.front();
  return fmt::format("{}{}, {}; {}, on {}, revision {}", winner_text(corpus_cells(scenes)),
                     quantity(scenes.size(), "scene"), points_text(rows), quantity(first.threads, "thread"),
                     first.processor, first.revision.empty() ? "unknown" : first.revision);
}

std::vector<PlainTable> corpus_tables(std::span<const CorpusRow> rows) {
  const auto scenes = scenes_of(rows);
  const auto cells = corpus_cells(scenes);
  std::vector<PlainTable> tables = {map_table(cells), winners_table(scenes, cells), profile_table(cells),
                                    regret_table(scenes), failures_table(rows)};
  std::erase_if(tables, [](const auto& table) { return table.rows.empty(); });
  return tables;
}

}  // namespace superstep
