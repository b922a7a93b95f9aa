#include "results/corpus/corpus_cells.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text/number.hpp"
#include "core/text/options.hpp"

namespace superstep {
namespace {

constexpr double levels[] = {1e-2, 1e-4, 1e-6, 1e-8};

std::vector<std::string> competitors(const SceneRows& scene) {
  std::vector<std::string> names;
  for (const CorpusRow* row : scene.rows)
    if (row->integrator != "auto" &&  // one of the others under another name: it can not win against it
        std::find(names.begin(), names.end(), row->integrator) == names.end())
      names.push_back(row->integrator);
  return names;
}

CorpusCell cell_of(const SceneRows& scene, double level) {
  CorpusCell cell{.facts = scene.facts, .level = level, .judged = true, .entrants = {}};
  const Number bar = scene.facts->reference_error;
  cell.judged = bar && bars_that_count * *bar <= level;
  if (!cell.judged) return cell;
  for (const auto& name : competitors(scene))
    if (const auto* row =
            cheapest_row(scene, level, [&](const CorpusRow& one) { return one.integrator == name; }))
      cell.entrants.push_back({row, {}});
  std::stable_sort(cell.entrants.begin(), cell.entrants.end(),
                   [](const Entrant& a, const Entrant& b) { return *a.row->cpu < *b.row->cpu; });
  for (auto& entrant : cell.entrants) entrant.behind = lead_of(*entrant.row, *cell.entrants.front().row);
  return cell;
}

}  // namespace

std::vector<SceneRows> scenes_of(std::span<const CorpusRow> rows) {
  std::vector<SceneRows> out;
  std::map<std::string, std::size_t> position;
  for (const auto& row : rows) {
    const auto [found, is_new] = position.emplace(row.scene, out.size());
    if (is_new) out.push_back({&row, {}});
    out[found->second].rows.push_back(&row);
  }
  return out;
}

std::span<const double> corpus_levels() {
  return levels;
}

Lead lead_of(const CorpusRow& slower, const CorpusRow& faster) {
  Lead lead;
  if (!slower.cpu || !faster.cpu || !(*faster.cpu > 0)) return lead;
  lead.estimate = *slower.cpu / *faster.cpu;
  lead.low = lead.high = lead.estimate;
  const std::size_t rounds = std::min(slower.samples.size(), faster.samples.size());
  for (std::size_t k = 0; k < rounds; ++k) {
    if (!(faster.samples[k] > 0)) continue;
    const double quotient = slower.samples[k] / faster.samples[k];
    lead.low = std::min(lead.low, quotient);
    lead.high = std::max(lead.high, quotient);
  }
  return lead;
}

std::size_t CorpusCell::tied() const {
  std::size_t count = entrants.empty() ? 0 : 1;
  for (std::size_t k = 1; k < entrants.size(); ++k)
    if (!entrants[k].behind.clear()) ++count;
  return count;
}

std::string CorpusCell::winner() const {
  return tied() == 1 ? entrants.front().row->integrator : "";
}

std::vector<CorpusCell> corpus_cells(std::span<const SceneRows> scenes) {
  std::vector<CorpusCell> out;
  for (const auto& scene : scenes)
    for (const double level : levels) out.push_back(cell_of(scene, level));
  return out;
}

bool close_to_best(double cpu, double best, double factor) noexcept {
  constexpr double short_run = 5e-3, excess = 2e-3;  // s
  return cpu <= factor * best || (best < short_run && cpu - best <= excess);
}

bool Regret::within(double limit) const {
  return !best || close_to_best(*row->cpu, *best->cpu, limit);
}

std::vector<Regret> regrets_of(std::span<const SceneRows> scenes) {
  std::vector<Regret> out;
  for (const auto& scene : scenes)
    for (const CorpusRow* row : scene.rows) {
      if (row->integrator != "auto") continue;
      Regret regret{.row = row};
      for (const auto& [key, value] : parse_spec(row->spec).settings)
        if (key == "rtol") regret.rtol = parse_number(value).value_or(0);
      if (!(regret.rtol > 0)) continue;
      const Number bar = row->reference_error;
      if (!bar || bars_that_count * *bar > regret.rtol) continue;  // the reference can not judge it
      regret.best =
          cheapest_row(scene, regret.rtol, [](const CorpusRow& one) { return one.integrator != "auto"; });
      if (row->error) regret.delivered = *row->error / regret.rtol;
      if (regret.best && row->cpu) regret.ratio = *row->cpu / *regret.best->cpu;
      out.push_back(regret);
    }
  return out;
}

CellAgreement agreement(std::span<const CorpusCell> a, std::span<const CorpusCell> b) {
  CellAgreement out;
  std::map<std::pair<std::string, double>, const CorpusCell*> other;
  for (const auto& cell : b) other[{cell.facts->scene, cell.level}] = &cell;
  for (const auto& cell : a) {
    const auto found = other.find({cell.facts->scene, cell.level});
    if (found == other.end() || cell.entrants.empty() || found->second->entrants.empty()) continue;
    ++out.cells;
    const std::string one = cell.winner(), two = found->second->winner();
    if (one.empty() || two.empty()) {
      ++out.untold;
    } else if (one == two) {
      ++out.same;
    } else {
      ++out.different;
      out.differences.push_back(fmt::format("{} at {:.0e}: {}, {}", cell.facts->scene, cell.level, one, two));
    }
  }
  return out;
}

}  // namespace superstep
