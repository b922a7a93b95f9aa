#include "bench/harness/run_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/harness/reference_pair.hpp"
#include "bench/harness/verification.hpp"
#include "bench/measure/metrics.hpp"
#include "core/text/number.hpp"

namespace superstep {
namespace {

constexpr double usual_tolerance = 1e-4;  // of runs that have none

/// Another family than the one that ran: `auto` tells in its choice which one that was.
MethodSpec other_family(const Scene& scene, const MethodSpec& spec, const RunResult& run) {
  const std::string& ran = spec.name() == "auto" ? run.choice : spec.text();
  const ReferencePair pair = reference_pair(scene);
  return ran.starts_with(pair.truth.name()) ? pair.check : pair.truth;
}

/// To the digits that one reads: a tenth of 1e-5 is no 1.0000000000000002e-06.
double rounded(double tolerance) {
  return parse_number(fmt::format("{:.6g}", tolerance)).value_or(tolerance);
}

}  // namespace

RunCheck check_run(const Scene& scene, const MethodSpec& spec, const RunResult& run,
                   std::span<const std::vector<double>> states, const std::atomic<bool>& stop,
                   Progress& progress, const RunLimits& limits) {
  constexpr double tighter = 0.1, tightest = 1e-12, worth_comparing = 0.5;
  RunCheck check;
  const double rtol = spec.rtol(), wanted = tighter * (rtol > 0 ? rtol : usual_tolerance);
  const MethodSpec other_method =
      other_family(scene, spec, run).with_tolerance(rounded(std::max(tightest, wanted)));
  check.spec = other_method.text();
  if (scene.rhs->reduction().total() == 0) {
    check.outcome = {Status::refused, "nothing is integrated, so that there is nothing to compare"};
    return check;
  }
  if (rtol > 0 && tightest > worth_comparing * rtol) {
    check.outcome = {Status::refused,
                     fmt::format("nothing here is known to be more accurate than {:g}", rtol)};
    return check;
  }
  const auto fields = scene.rhs->fields();
  check.distance.assign(fields.size(), 0.0);
  RunRequest request{.spans = run.spans, .stop = &stop, .progress = &progress, .limits = limits};
  request.observe = [&](std::size_t k, double, std::span<const double> state) {
    for (std::size_t f = 0; f < fields.size(); ++f)
      check.distance[f] = std::max(check.distance[f], deviation(fields[f], states[k], state).rms);
  };
  progress.begin("verifying by " + check.spec, scene.t_end);
  const RunResult other = run_one(scene, other_method, request);
  progress.end();
  check.outcome = other.outcome;
  check.spans = other.spans;
  check.cpu_seconds = other.cpu_pilot + other.cpu_prepare + other.cpu_stepping;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const bool asked = rtol > 0 && f < check.spans.size();
    const double allowed = asked ? allowed_error(scene, fields[f], rtol, check.spans[f]) : 0;
    check.delivered.push_back(allowed > 0 ? std::optional(check.distance[f] / allowed) : std::nullopt);
  }
  return check;
}

Outcome judge_check(const Scene& scene, const RunCheck& check) {
  constexpr double times_tolerance = 10, part_of_span = 0.1;
  if (!check.outcome.ok()) return {};
  const auto fields = scene.rhs->fields();
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const bool beyond = check.delivered[f] && *check.delivered[f] > times_tolerance;
    const double most = allowed_error(scene, fields[f], part_of_span, check.spans[f]);
    if (!beyond && !(check.distance[f] > most)) continue;
    return {Status::inaccurate,
            fmt::format("the {} is {:.3g} {} rms away from that of {}; take shorter steps or "
                        "a tighter tolerance",
                        fields[f].name, check.distance[f], fields[f].unit, check.spec)};
  }
  return {};
}

void add_check(const RunCheck& check, RunRecord& record) {
  if (check.outcome.status != Status::refused) record.verified_by = check.spec;
  record.cpu_verify = check.cpu_seconds;
  if (!check.outcome.ok()) return;
  for (const auto& delivered : check.delivered)
    if (delivered) record.delivered = std::max(record.delivered.value_or(0.0), *delivered);
}

}  // namespace superstep
