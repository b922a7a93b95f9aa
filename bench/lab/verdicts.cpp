#include "bench/lab/verdicts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "integrators/schemes/stability_model.hpp"

namespace superstep {
namespace {

using Grade = Verdict::Grade;

constexpr double much_overshoot = 0.1;  // spans

using Methods = std::vector<const MethodStability*>;

Methods methods_of(const StabilityResults& results, const std::string& family, const std::string& detail) {
  Methods out;
  for (const auto& method : results.methods)
    if (method.family == family && (detail.empty() || method.order == detail || method.parameters == detail))
      out.push_back(&method);
  return out;
}

double largest(const Methods& methods, double MethodStability::*value) {
  double out = 0;
  for (const auto* method : methods) out = std::max(out, method->*value);
  return out;
}

bool all_agree(const Methods& methods) {
  return std::all_of(methods.begin(), methods.end(), [](const auto* method) { return method->agrees; });
}

/// Largest overshoot of a method over the sweeps; 0 when it was not measured.
double overshoot_of(const StabilityResults& results, const std::string& method, double nu_from = 0) {
  double out = 0;
  for (const auto& point : results.sweeps)
    for (const auto& overshoot : point.overshoots)
      if (overshoot.method == method && point.nu >= nu_from) out = std::max(out, overshoot.spans);
  return out;
}

std::string overshoot_text(double spans) {
  if (spans < 1e-6)
    return "First steps over random networks stayed within the range of initial and fixed values.";
  return fmt::format(
      "First steps over random networks left the range of initial and fixed values by up to {:.2f} spans.",
      spans);
}

std::string disagreement_text(const Methods& methods) {
  double growth = 0;
  for (const auto* method : methods)
    if (method->beyond) growth = std::max(growth, std::abs(*method->beyond_measured / *method->beyond - 1));
  return fmt::format(
      "Theory and measurement differ: R(z) by up to {:.1e}, growth beyond the limit by up to {:.2g} %. Do "
      "not trust it "
      "here.",
      largest(methods, &MethodStability::difference), 100 * growth);
}

const char* outcome_text(Tendency tendency) {
  switch (tendency) {
    case Tendency::decays:
      return "stable";
    case Tendency::grows:
      return "UNSTABLE";
    case Tendency::unclear:
      return "at the limit";
  }
  return "";
}

Verdict judge_forward_euler(const StabilityResults& results) {
  const auto& study = results.critical_step;
  const std::string name = "forward-euler";
  if (!std::isfinite(study.limit)) return {name, Grade::safe, "Nothing limits its step here."};
  const auto methods = methods_of(results, name, "");
  if (!all_agree(methods)) return {name, Grade::unsafe, disagreement_text(methods)};
  std::vector<std::string> rules;
  for (const auto& estimate : study.estimates)
    if (estimate.note == certified_bound || estimate.note == published_rule)
      rules.push_back(fmt::format("{} at {:.2f} ({}, {})", estimate.name, estimate.of_limit, estimate.note,
                                  outcome_text(estimate.tendency)));
  const auto [lowest, highest] =
      std::minmax_element(results.sweeps.begin(), results.sweeps.end(),
                          [](const auto& a, const auto& b) { return a.alpha < b.alpha; });
  const std::string text = fmt::format(
      "Stable up to h = {:.5g} s by bisection; 2/lambda_max by Lanczos is {:.4f} of that. In units of it: "
      "{}. No "
      "fixed part of the pairwise step is safe everywhere: over random networks the limit lay at alpha = "
      "{:.2f} to "
      "{:.2f}. {}",
      study.limit, study.lanczos_ratio, fmt::join(rules, ", "), lowest->alpha, highest->alpha,
      overshoot_text(overshoot_of(results, "forward_euler")));
  return {name, Grade::careful, text};
}

/// "n = 50 at nu = 0.05, n = 32 at nu = 0.01": where an order first goes wrong; empty when it never does.
std::string first_wrong(const StabilityResults& results, const std::string& order) {
  std::vector<std::string> places;
  std::optional<double> nu;
  for (const auto& row : results.rounding)
    if (row.order == order && !row.right && row.nu != nu) {
      nu = row.nu;
      places.push_back(fmt::format("n = {} at nu = {:g}", row.n, row.nu));
    }
  return fmt::format("{}", fmt::join(places, ", "));
}

/// Parameter sets whose measurement on the network itself departs from theory.
std::string lost_here_text(const Methods& methods) {
  std::vector<std::string> sets;
  for (const auto* method : methods)
    if (!method->agrees) sets.push_back(method->parameters);
  return sets.empty()
             ? ""
             : fmt::format(" On this network it departs from theory with {}.", fmt::join(sets, " and "));
}

double worst_rounding(const StabilityResults& results, const std::string& order, int n_up_to) {
  double worst = 0;
  for (const auto& row : results.rounding)
    if (row.order == order && row.n <= n_up_to) worst = std::max(worst, row.rounding_error);
  return worst;
}

Verdict judge_superstep(const StabilityResults& results, const std::string& order) {
  const auto methods = methods_of(results, "sts", order);
  const std::string name = "sts, order " + order;
  const std::string wrong = first_wrong(results, order);
  if (!wrong.empty()) {
    constexpr int most = 25;
    return {name, Grade::unsafe,
            fmt::format("Rounding destroys it from {}.{} Up to n = {}, where the published sets end, a run "
                        "gathers at most {:.1e} spans of rounding. Use recurrence or leja.",
                        wrong, lost_here_text(methods), most, worst_rounding(results, order, most))};
  }
  if (!all_agree(methods)) return {name, Grade::unsafe, disagreement_text(methods)};
  const int most = results.rounding.back().n;
  constexpr double strong_nu = 0.05;
  return {
      name, Grade::careful,
      fmt::format("No growth; up to n = {} a run gathers at most {:.1e} spans of rounding. Small nu damps "
                  "stiff modes little: they keep up to {:.4f} in a superstep. {} From nu = {:g} on it was "
                  "{:.2f} spans.",
                  most, worst_rounding(results, order, most), largest(methods, &MethodStability::damping),
                  overshoot_text(overshoot_of(results, "sts")), strong_nu,
                  overshoot_of(results, "sts", strong_nu))};
}

Verdict judge_stabilised(const StabilityResults& results, const std::string& family) {
  const auto methods = methods_of(results, family, "");
  if (!all_agree(methods)) return {family, Grade::unsafe, disagreement_text(methods)};
  double nearest = 1e300, farthest = 0;
  for (const auto* method : methods) {
    if (!method->limit) continue;
    nearest = std::min(nearest, *method->limit / *method->beta);
    farthest = std::max(farthest, *method->limit / *method->beta);
  }
  const double overshoot = overshoot_of(results, family);
  const std::string text = fmt::format(
      "No growth up to beta for {} to {} stages; it begins at {:.4f} to {:.4f} beta. Stiff modes keep "
      "at most {:.3f} in a step. {}",
      methods.front()->stages, methods.back()->stages, nearest, farthest,
      largest(methods, &MethodStability::damping), overshoot_text(overshoot));
  return {family, overshoot > much_overshoot ? Grade::careful : Grade::safe, text};
}

Verdict judge_trapezoidal(const StabilityResults& results, const std::string& phi) {
  const auto methods = methods_of(results, "trapezoidal", "phi=" + phi);
  const std::string name = "trapezoidal, phi = " + phi;
  if (!all_agree(methods)) return {name, Grade::unsafe, disagreement_text(methods)};
  const double overshoot = overshoot_of(results, "trapezoidal_" + phi);
  const auto& stiffest = *methods.back();
  const std::string stiff =
      stiffest.stiff < 0
          ? fmt::format("keeps {:.4f} in a step and changes its sign: it rings", -stiffest.stiff)
          : fmt::format("keeps {:.4f} in a step and its sign", stiffest.stiff);
  return {name, overshoot > much_overshoot ? Grade::careful : Grade::safe,
          fmt::format("No growth at any step. At h lambda = {:g} a mode {}. {}", stiffest.z_stiff, stiff,
                      overshoot_text(overshoot))};
}

/// One method at all frozen states; `which` = its place among their limits.
Verdict judge_frozen(const StabilityResults& results, std::size_t which) {
  const auto& first = results.states.front().limits[which];
  const std::string name =
      first.parameters.empty() ? first.family : fmt::format("{}, {}", first.family, first.parameters);
  std::vector<std::string> limits, wrong;
  int predicted = 0;
  for (const auto& state : results.states) {
    const auto& limit = state.limits[which];
    limits.push_back(fmt::format("{:.4g} s at t = {:.4g} s", limit.measured, state.time));
    predicted += limit.verdict == FrozenLimit::Verdict::agrees;
    if (limit.verdict == FrozenLimit::Verdict::differs)
      wrong.push_back(fmt::format("{:.4g} s at t = {:.4g} s", *limit.predicted, state.time));
  }
  std::string text = fmt::format("Longest stable steps: {}.", fmt::join(limits, ", "));
  if (!wrong.empty())
    return {name, Grade::unsafe,
            text + fmt::format(" Eigenvalues predict {}: do not trust either.", fmt::join(wrong, ", "))};
  text += predicted > 0 ? fmt::format(" Eigenvalues predict {} of {} within 2 %.", predicted, limits.size())
                        : " A complex spectrum predicts none of them.";
  return {name, Grade::careful, text};
}

std::vector<Verdict> judge_frozen_states(const StabilityResults& results) {
  std::vector<Verdict> verdicts;
  if (results.states.empty()) return verdicts;
  for (std::size_t k = 0; k < results.states.front().limits.size(); ++k)
    verdicts.push_back(judge_frozen(results, k));
  return verdicts;
}

}  // namespace

std::vector<Verdict> judge_methods(const StabilityResults& results) {
  if (!results.linear) return judge_frozen_states(results);
  std::vector<Verdict> verdicts = {judge_forward_euler(results)};
  if (results.methods.empty()) return verdicts;
  for (const char* order : {"recurrence", "leja", "natural"})
    verdicts.push_back(judge_superstep(results, order));
  for (std::size_t k = 0; k < results.methods.size(); ++k) {
    const auto& one = results.methods[k];
    const bool first = k == 0 || results.methods[k - 1].family != one.family;
    if (first && is_stabilised(one)) verdicts.push_back(judge_stabilised(results, one.family));
  }
  for (const char* phi : {"0.5", "0.6", "1"}) verdicts.push_back(judge_trapezoidal(results, phi));
  return verdicts;
}

}  // namespace superstep
