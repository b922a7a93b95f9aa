#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <ostream>

#include "audit/oracle/linear_truth.hpp"
#include "audit/special_audits.hpp"
#include "audit/verdict.hpp"
#include "bench/measure/run_one.hpp"

namespace superstep::audit {
namespace {

/// How the bounds of one SPEC held.
struct BoundTally {
  std::size_t runs = 0, failed = 0, without = 0, violated = 0;
  std::vector<double> over_error;       ///< bound over error, as rms
  std::vector<double> over_truncation;  ///< the same in the capacity norm where truncation is what there is
  std::vector<double> rounding;         ///< part of the bound
};

/// The largest errors of a run over its outputs: rms, and weighted with capacities [K or V].
struct Errors {
  double rms = 0, weighted = 0;
};

Errors errors_in_both_norms(const Scene& scene, const Truth& truth, std::size_t output,
                            std::span<const double> state) {
  const auto values = scene.values_on_nodes(0, scene.output_times[output], state);
  const auto& graph = scene.fields[0].graph;
  const auto& right = truth.fields[0].values[output];
  double square = 0, weighted = 0, capacity = 0, count = 0;
  for (std::size_t node = 0; node < values.size(); ++node) {
    if (graph.is_fixed[node]) continue;
    const double error = values[node] - right[node];
    square += error * error;
    weighted += graph.capacity[node] * error * error;
    capacity += graph.capacity[node];
    ++count;
  }
  return {std::sqrt(square / count), std::sqrt(weighted / capacity)};
}

/// Bound of a vector's rms by its capacity-weighted rms.
double rms_over_weighted(const Scene& scene) {
  const auto capacity = scene.rhs->capacities();
  double total = 0;
  for (const double c : capacity) total += c;
  return std::sqrt(
      total / (static_cast<double>(capacity.size()) * *std::min_element(capacity.begin(), capacity.end())));
}

}  // namespace

std::size_t print_bounds_audit(std::ostream& out, const SeedRange& seeds, const SceneWishes& wishes,
                               const std::vector<Contender>& methods, const std::vector<double>& rtols,
                               bool list) {
  constexpr double nothing_else = 0.1;  // rounding over truncation, at most, where truncation is judged
  std::map<std::pair<std::string, double>, BoundTally> tallies;
  for (auto seed = seeds.first; seed < seeds.last; ++seed) {
    const auto stated = state_scene(seed, wishes);
    const Truth truth = linear_truth_in_sixty_digits(stated);
    const Scene scene = build_scene(stated);
    if (!is_judged(scene, truth, 0)) continue;
    const double factor = rms_over_weighted(scene),
                 rounding_of_truth = 0.5 * std::numeric_limits<double>::epsilon() * truth.fields[0].size();
    for (const auto& method : methods)
      for (const double rtol : rtols) {
        auto& tally = tallies[{method.label, rtol}];
        Errors worst;
        RunRequest request;
        request.observe = [&](std::size_t output, double, std::span<const double> state) {
          const Errors now = errors_in_both_norms(scene, truth, output, state);
          worst = {std::max(worst.rms, now.rms), std::max(worst.weighted, now.weighted)};
        };
        const RunResult run = run_one(scene, method.spec(rtol), request);
        ++tally.runs;
        if (!run.outcome.ok()) {
          ++tally.failed;
          continue;
        }
        const auto bound = error_bound_of(run), rounding = rounding_bound_of(run);
        if (!bound) {
          ++tally.without;
          continue;
        }
        const double span = run.spans.front();
        if (worst.rms > *bound * span + rounding_of_truth) {
          ++tally.violated;
          if (list)
            out << fmt::format(
                "seed {} {} rtol={:g}, t*lambda={:.2g}: error {:.3g} of the span above {:.3g}\n", seed,
                method.label, rtol, stated.t_lambda, worst.rms / span, *bound);
        }
        if (worst.rms > 0) tally.over_error.push_back(*bound * span / worst.rms);
        tally.rounding.push_back(*rounding / *bound);
        const double truncation = (*bound - *rounding) * span / factor;
        if (*rounding * span / factor < nothing_else * worst.weighted)
          tally.over_truncation.push_back(truncation / worst.weighted);
      }
  }
  out << fmt::format("{:<31} {:>6} {:>6} {:>6} {:>8} {:>9} {:>18} {:>22} {:>16}\n", "method", "rtol", "runs",
                     "failed", "no bound", "violated", "bound/error median", "truncation, in C-norm",
                     "rounding, median");
  std::size_t violated = 0;
  for (auto& [who, tally] : tallies) {
    for (auto* numbers : {&tally.over_error, &tally.over_truncation, &tally.rounding})
      std::sort(numbers->begin(), numbers->end());
    out << fmt::format("{:<31} {:>6.0e} {:>6} {:>6} {:>8} {:>9} {:>18.3g} {:>13.3g} of {:>5} {:>16.2g}\n",
                       who.first, who.second, tally.runs, tally.failed, tally.without, tally.violated,
                       quantile(tally.over_error, 0.5), quantile(tally.over_truncation, 0.5),
                       tally.over_truncation.size(), quantile(tally.rounding, 0.5));
    violated += tally.violated;
  }
  return violated;
}

}  // namespace superstep::audit
