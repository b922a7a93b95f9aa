#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>

#include "audit/special_audits.hpp"
#include "audit/verdict.hpp"
#include "bench/measure/run_one.hpp"

namespace superstep::audit {
namespace {

struct SpanTally {
  std::size_t fields = 0, by_pilot = 0, wrong_about_rest = 0;
  std::vector<double> deviations;  ///< |found / true - 1| of fields that move
};

}  // namespace

std::vector<SpanPair> compare_spans(const StatedScene& stated, const Truth& truth) {
  const Scene scene = build_scene(stated);
  const Spans found = scene_spans(scene, nullptr);
  std::vector<SpanPair> pairs;
  for (std::size_t f = 0; f < truth.fields.size(); ++f)
    if (const auto view = scene.fields[f].view; view >= 0)
      pairs.push_back({truth.fields[f].name, found.spans[static_cast<std::size_t>(view)],
                       truth.fields[f].span(), found.pilot, found.how});
  return pairs;
}

void print_span_audit(std::ostream& out, const SeedRange& seeds, const SceneWishes& wishes, bool list) {
  constexpr double worth_a_line = 0.1;
  std::map<std::string, SpanTally> tallies;
  for (auto seed = seeds.first; seed < seeds.last; ++seed) {
    const auto stated = state_scene(seed, wishes);
    const auto truth = truth_or_reason(seed, stated, out);
    if (!truth) continue;
    auto& tally = tallies[stated.kind];
    for (const auto& pair : compare_spans(stated, *truth)) {
      ++tally.fields;
      if (pair.pilot) ++tally.by_pilot;
      double deviation = 0;
      if (pair.right > 0) {
        deviation = std::abs(pair.found / pair.right - 1);
        tally.deviations.push_back(deviation);
      } else if (pair.found != 0) {
        ++tally.wrong_about_rest;
      }
      if (list && (deviation > worth_a_line || (pair.right == 0) != (pair.found == 0)))
        out << fmt::format("seed {} {} {}: found {:.6g}, true {:.6g}; {}\n", seed, stated.kind, pair.field,
                           pair.found, pair.right, pair.how);
    }
  }
  out << fmt::format("{:<21} {:>7} {:>9} {:>9} {:>9} {:>9} {:>12}\n", "spans of class", "fields", "by pilot",
                     "median", "95 %", "worst", "moves, or not");
  for (auto& [kind, tally] : tallies) {
    std::sort(tally.deviations.begin(), tally.deviations.end());
    out << fmt::format("{:<21} {:>7} {:>9} {:>9.2g} {:>9.2g} {:>9.2g} {:>12}\n", kind, tally.fields,
                       tally.by_pilot, quantile(tally.deviations, 0.5), quantile(tally.deviations, 0.95),
                       quantile(tally.deviations, 1), tally.wrong_about_rest);
  }
}

}  // namespace superstep::audit
