#include "results/corpus/corpus_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace superstep {
namespace {

constexpr double close_factor = 1.3, never_factor = 2;  // what is asked of `auto`
constexpr double least_memory = 0.1;                    // MB; less is nothing

/// Sums over the cells of a group.
class Group {
 public:
  void add(const CorpusCell& cell) {
    if (cell.entrants.empty()) return;
    ++cells_;
    const std::size_t tied = cell.tied();
    for (std::size_t k = 0; k < cell.entrants.size(); ++k) {
      const Entrant& entrant = cell.entrants[k];
      MethodScore& score = scores_[entrant.row->integrator];
      ++score.reached;
      if (k == 0 && tied == 1) ++score.alone;
      if (tied > 1 && (k == 0 || !entrant.behind.clear())) ++score.shared;
      score.factor += std::log(entrant.behind.estimate);
      score.memory += std::log(std::max(least_memory, entrant.row->memory.value_or(0)));
    }
  }

  [[nodiscard]] MapCell result(std::string scene_class, std::string size, double level) const {
    MapCell out{std::move(scene_class), std::move(size), level, cells_, {}};
    for (const auto& [name, sums] : scores_) {
      MethodScore score = sums;
      const auto n = static_cast<double>(score.reached);
      score.integrator = name;
      score.factor = std::exp(score.factor / n);
      score.memory = std::exp(score.memory / n);
      out.methods.push_back(std::move(score));
    }
    std::stable_sort(out.methods.begin(), out.methods.end(), [](const auto& a, const auto& b) {
      return a.reached != b.reached ? a.reached > b.reached : a.factor < b.factor;
    });
    return out;
  }

 private:
  std::size_t cells_ = 0;
  std::map<std::string, MethodScore> scores_;  // factor and memory hold sums of logarithms
};

/// Values of `of(cell)` in the order in which they come.
template <class Of>
std::vector<std::string> values_in_order(std::span<const CorpusCell> cells, Of of) {
  std::vector<std::string> out;
  for (const auto& cell : cells)
    if (const std::string value = of(cell); std::find(out.begin(), out.end(), value) == out.end())
      out.push_back(value);
  return out;
}

std::string size_of(const CorpusCell& cell) {
  return size_class(cell.facts->unknowns);
}

}  // namespace

std::string size_class(std::uint64_t unknowns) {
  const double decade = std::round(std::log10(static_cast<double>(std::max<std::uint64_t>(1, unknowns))));
  return fmt::format("1e{:.0f}", decade);
}

std::vector<MapCell> corpus_map(std::span<const CorpusCell> cells) {
  std::vector<MapCell> out;
  const auto add = [&](const std::string& scene_class, const std::string& size) {
    for (const double level : corpus_levels()) {
      Group group;
      for (const auto& cell : cells)
        if (cell.level == level && (scene_class.empty() || cell.facts->scene_class == scene_class) &&
            (size.empty() || size_of(cell) == size))
          group.add(cell);
      out.push_back(group.result(scene_class, size, level));
    }
  };
  for (const auto& name : values_in_order(cells, [](const auto& cell) { return cell.facts->scene_class; }))
    add(name, "");
  auto sizes = values_in_order(cells, size_of);
  std::sort(sizes.begin(), sizes.end());
  for (const auto& size : sizes) add("", size);
  return out;
}

double Profile::within(double factor) const {
  const auto end = std::upper_bound(ratios.begin(), ratios.end(), factor);
  return cells == 0 ? 0 : static_cast<double>(end - ratios.begin()) / static_cast<double>(cells);
}

std::vector<Profile> corpus_profiles(std::span<const CorpusCell> cells, double level) {
  std::map<std::string, Profile> profiles;
  std::size_t total = 0;
  for (const auto& cell : cells) {
    if (cell.entrants.empty() || (level > 0 && cell.level != level)) continue;
    ++total;
    for (const auto& entrant : cell.entrants)
      profiles[entrant.row->integrator].ratios.push_back(entrant.behind.estimate);
  }
  std::vector<Profile> out;
  for (auto& [name, profile] : profiles) {
    profile.integrator = name;
    profile.cells = total;
    std::sort(profile.ratios.begin(), profile.ratios.end());
    out.push_back(std::move(profile));
  }
  std::stable_sort(out.begin(), out.end(), [](const Profile& a, const Profile& b) {
    return a.within(1) != b.within(1) ? a.within(1) > b.within(1) : a.within(2) > b.within(2);
  });
  return out;
}

std::vector<Tally> corpus_tallies(std::span<const CorpusRow> rows) {
  std::vector<Tally> out;
  for (const auto& row : rows) {
    auto found = std::find_if(out.begin(), out.end(),
                              [&](const Tally& one) { return one.integrator == row.integrator; });
    if (found == out.end()) found = out.insert(out.end(), Tally{.integrator = row.integrator, .others = {}});
    ++found->points;
    if (row.ok())
      ++found->ok;
    else
      found->others.push_back(&row);
  }
  return out;
}

RegretSummary summarize(std::span<const Regret> regrets) {
  RegretSummary out;
  for (const auto& regret : regrets) {
    ++out.count;
    const bool kept = regret.row->ok() && regret.delivered <= 1;
    if (kept) ++out.kept;
    const bool ended = regret.row->cpu.has_value();
    if (ended && regret.within(close_factor)) ++out.close;
    if (!ended || !regret.within(never_factor)) {
      if (out.never_beyond) out.worst = 0;
      out.never_beyond = false;
      out.worst = std::max(out.worst, regret.ratio);
    } else if (out.never_beyond) {
      out.worst = std::max(out.worst, regret.ratio);
    }
  }
  return out;
}

}  // namespace superstep
