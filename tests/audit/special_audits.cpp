#include "audit/special_audits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <ostream>

#include "audit/verdict.hpp"
#include "bench/harness/reference.hpp"

namespace superstep::audit {
namespace {

constexpr double celsius_to_kelvin = 273.15;
// Bars that references aim at, over the span, and below which roundings of the values decide.
constexpr double aim_for_linear_scenes = 1e-10, aim_for_others = 1e-8, roundings = 100;

/// How one method at one tolerance took the shift.
struct ShiftTally {
  std::vector<double> ratios;  ///< larger over smaller delivered
  std::size_t rounding = 0;    ///< scenes in which roundings decide what is delivered
  std::size_t status = 0;      ///< scenes that end otherwise than before
};

struct ReferenceTally {
  std::size_t scenes = 0, missing = 0, without_bar = 0, uncovered = 0, narrow = 0;
  std::vector<double> bars, errors;  ///< over the span
};

/// Below this multiple of the floor the error consists of roundings, which no shift leaves alone.
bool rounding_decides(const Truth& truth, const Row& row, double rtol) {
  for (const auto& field : truth.fields)
    if (rtol * field.span() < rounding_floor(field)) return true;
  for (const auto& field : truth.fields)
    if (field.span() > 0 && row.error * field.span() < 0.1 * rounding_floor(field)) return true;
  return false;
}

void add_shift(const Row& before, const Row& after, const Truth& truth, ShiftTally& tally) {
  if (before.status != after.status) ++tally.status;
  if (before.delivered < 0 || after.delivered < 0) return;
  if (before.floored || after.floored || rounding_decides(truth, after, after.rtol) ||
      rounding_decides(truth, before, before.rtol)) {
    ++tally.rounding;
    return;
  }
  const double low = std::min(before.delivered, after.delivered),
               high = std::max(before.delivered, after.delivered);
  tally.ratios.push_back(high == low ? 1 : high / low);
}

}  // namespace

std::optional<Truth> truth_or_reason(std::uint64_t seed, const StatedScene& stated, std::ostream& out) {
  try {
    return find_truth(stated);
  } catch (const std::exception& error) {
    out << fmt::format("seed {} {}: not judged: {}\n", seed, stated.kind, error.what());
    return std::nullopt;
  }
}

void print_shift_audit(std::ostream& out, const SeedRange& seeds, const SceneWishes& wishes,
                       const std::vector<Contender>& methods, const std::vector<double>& rtols,
                       const AuditSettings& settings, TimeLimit& limit, bool list) {
  std::map<std::pair<std::string, double>, ShiftTally> tallies;
  for (auto seed = seeds.first; seed < seeds.last; ++seed) {
    const auto stated = state_scene(seed, wishes);
    if (!may_be_shifted(stated)) continue;
    const auto moved = shifted(stated, celsius_to_kelvin);
    const auto found = truth_or_reason(seed, stated, out), found_moved = truth_or_reason(seed, moved, out);
    if (!found || !found_moved) continue;
    const Truth &truth = *found, &moved_truth = *found_moved;
    const Scene scene = build_scene(stated), moved_scene = build_scene(moved);
    for (const auto& method : methods)
      for (const double rtol : rtols) {
        if (!method.adaptive) continue;
        const Row before = judge(stated, scene, truth, method, rtol, settings, limit);
        const Row after = judge(moved, moved_scene, moved_truth, method, rtol, settings, limit);
        auto& tally = tallies[{method.label, rtol}];
        const auto count = tally.ratios.size();
        add_shift(before, after, moved_truth, tally);
        if (list && tally.ratios.size() > count && tally.ratios.back() > 1.5)
          out << fmt::format(
              "seed {} {}: {} rtol={:g}: delivered {:.3g} before, {:.3g} after; steps {} and {}\n", seed,
              stated.kind, method.label, rtol, before.delivered, after.delivered, before.steps, after.steps);
      }
  }
  out << fmt::format("{:<31} {:>6} {:>6} {:>11} {:>9} {:>8} {:>9}\n", "method", "rtol", "scenes",
                     "within 2 %", "> 1.5x", "worst", "rounding");
  for (auto& [who, tally] : tallies) {
    std::sort(tally.ratios.begin(), tally.ratios.end());
    const auto within = [&](double ratio) {
      return static_cast<std::size_t>(std::upper_bound(tally.ratios.begin(), tally.ratios.end(), ratio) -
                                      tally.ratios.begin());
    };
    out << fmt::format("{:<31} {:>6.0e} {:>6} {:>11} {:>9} {:>8.3g} {:>9}\n", who.first, who.second,
                       tally.ratios.size(), percent(within(1.02), tally.ratios.size()),
                       tally.ratios.size() - within(1.5), quantile(tally.ratios, 1), tally.rounding);
  }
}

void print_reference_audit(std::ostream& out, const SeedRange& seeds, const SceneWishes& wishes, bool list) {
  std::map<std::string, ReferenceTally> tallies;
  for (auto seed = seeds.first; seed < seeds.last; ++seed) {
    const auto stated = state_scene(seed, wishes);
    const auto found = truth_or_reason(seed, stated, out);
    if (!found) continue;
    const Truth& truth = *found;
    const Scene scene = build_scene(stated);
    auto& tally = tallies[stated.kind];
    ++tally.scenes;
    Progress silent(false);
    ReferenceRequest request;
    request.spec = std::string();
    request.use_cache = false;
    const auto result = obtain_reference(scene, ProbeSet(scene), request, silent);
    if (!result.reference) {
      ++tally.missing;
      if (list)
        out << fmt::format("seed {} {}: no reference: {}\n", seed, stated.kind, result.outcome.reason);
      continue;
    }
    if (list)
      for (const auto& warning : result.warnings)
        out << fmt::format("seed {} {}: {}\n", seed, stated.kind, warning);
    const auto errors = errors_of(scene, truth, result.reference->states);
    if (result.reference->error_bar.empty()) {
      ++tally.without_bar;
      continue;
    }
    double bar = 0, error = 0, largest = 0;
    bool covered = true;
    for (std::size_t f = 0; f < truth.fields.size(); ++f) {
      const auto view = scene.fields[f].view;
      const double span = truth.fields[f].span();
      if (view < 0 || !(span > 0)) continue;
      const double own = result.reference->error_bar[static_cast<std::size_t>(view)];
      bar = std::max(bar, own / span);
      error = std::max(error, errors[f] / span);
      largest =
          std::max(largest, std::max(std::abs(truth.fields[f].low), std::abs(truth.fields[f].high)) / span);
      covered = covered && errors[f] <= own + truth.fields[f].error;
    }
    if (!covered) ++tally.uncovered;
    if (!covered && list)
      out << fmt::format("seed {} {} t*lambda={:.2g}: error {:.2g} of the span above the bar {:.2g}\n", seed,
                         stated.kind, stated.t_lambda, error, bar);
    const double aim = std::max(scene.rhs->traits().linear ? aim_for_linear_scenes : aim_for_others,
                                roundings * std::numeric_limits<double>::epsilon() * largest);
    if (bar <= aim) ++tally.narrow;
    if (bar > aim && list)
      out << fmt::format(
          "seed {} {} t*lambda={:.2g}: bar {:.2g} of the span, error {:.2g}, values to {:.2g} spans\n", seed,
          stated.kind, stated.t_lambda, bar, error, largest);
    tally.bars.push_back(bar);
    tally.errors.push_back(error);
  }
  out << fmt::format("{:<21} {:>6} {:>8} {:>7} {:>10} {:>8} {:>11} {:>11} {:>11} {:>11}\n", "class", "scenes",
                     "missing", "no bar", "uncovered", "narrow", "bar median", "bar 95 %", "worst bar",
                     "worst error");
  for (auto& [kind, tally] : tallies) {
    std::sort(tally.bars.begin(), tally.bars.end());
    std::sort(tally.errors.begin(), tally.errors.end());
    out << fmt::format("{:<21} {:>6} {:>8} {:>7} {:>10} {:>8} {:>11.2g} {:>11.2g} {:>11.2g} {:>11.2g}\n",
                       kind, tally.scenes, tally.missing, tally.without_bar, tally.uncovered,
                       percent(tally.narrow, tally.bars.size()), quantile(tally.bars, 0.5),
                       quantile(tally.bars, 0.95), quantile(tally.bars, 1), quantile(tally.errors, 1));
  }
}

}  // namespace superstep::audit
