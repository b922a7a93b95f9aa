#include "audit/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/measure/run_one.hpp"
#include "core/text/options.hpp"
#include "integrators/registry.hpp"

namespace superstep::audit {
namespace {

/// Variants of adaptive methods that differ in more than speed: other solvers, another basis.
constexpr const char* variants[] = {"trapezoidal:solver=klu",
                                    "trapezoidal:solver=cholmod",
                                    "trapezoidal:solver=pcg",
                                    "cvode:linsol=klu",
                                    "trapezoidal:solver=fixed-point",
                                    "cvode:linsol=pcg",
                                    "cvode:linsol=gmres",
                                    "cvode:linsol=cholmod",
                                    "exponential:basis=lanczos",
                                    "exponential:basis=chebyshev",
                                    "exponential:basis=shift-invert"};
constexpr const char* fixed_steps[] = {"forward-euler", "sts:n=10,nu=1e-2"};

Contender contender(const std::string& spec) {
  return {spec, find_integrator(parse_spec(spec).name).adaptive};
}

/// The oracle's spans, one for each field of the right-hand side.
std::vector<double> true_spans(const Scene& scene, const Truth& truth) {
  std::vector<double> spans(scene.rhs->fields().size(), 0.0);
  for (std::size_t f = 0; f < truth.fields.size(); ++f)
    if (const auto view = scene.fields[f].view; view >= 0)
      spans[static_cast<std::size_t>(view)] = truth.fields[f].span();
  return spans;
}

/// Largest part of what a run may be wrong by that it is wrong by, and of the span.
struct Score {
  std::size_t outputs = 0;
  double error = 0, delivered = 0;
};
void add_output(const Scene& scene, const Truth& truth, double rtol, std::span<const double> state,
                Score& score) {
  const auto errors = errors_at(scene, truth, score.outputs++, state);
  for (std::size_t f = 0; f < errors.size(); ++f) {
    if (!is_judged(scene, truth, f)) continue;
    const double span = truth.fields[f].span();
    score.error = std::max(score.error, errors[f] / span);
    score.delivered =
        std::max(score.delivered, errors[f] / std::max(rtol * span, rounding_floor(truth.fields[f])));
  }
}

}  // namespace

std::string Contender::spec(double rtol) const {
  if (!adaptive) return label;
  return fmt::format("{}{}rtol={:g}", label, label.find(':') == std::string::npos ? ':' : ',', rtol);
}

std::vector<Contender> contenders(const std::vector<std::string>& specs) {
  std::vector<Contender> out;
  for (const auto& spec : specs) out.push_back(contender(spec));
  if (!specs.empty()) return out;
  for (const auto& entry : integrators())
    if (entry.adaptive) out.push_back({entry.name, true});
  for (const auto* spec : variants) out.push_back(contender(spec));
  for (const auto* spec : fixed_steps) out.push_back(contender(spec));
  return out;
}

double rounding_floor(const FieldTruth& field) {
  return 100 * std::numeric_limits<double>::epsilon() * field.size();
}

bool is_judged(const Scene& scene, const Truth& truth, std::size_t field) {
  return scene.fields[field].view >= 0 && truth.fields[field].span() > 0;
}

std::vector<double> errors_at(const Scene& scene, const Truth& truth, std::size_t output,
                              std::span<const double> state) {
  std::vector<double> errors(truth.fields.size(), 0.0);
  for (std::size_t f = 0; f < errors.size(); ++f) {
    if (!is_judged(scene, truth, f)) continue;
    const auto values = scene.values_on_nodes(f, scene.output_times[output], state);
    const auto& right = truth.fields[f].values[output];
    double sum = 0;
    for (std::size_t node = 0; node < values.size(); ++node)
      if (!scene.fields[f].graph.is_fixed[node])
        sum += (values[node] - right[node]) * (values[node] - right[node]);
    const auto count = scene.rhs->fields()[static_cast<std::size_t>(scene.fields[f].view)].count;
    errors[f] = std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, count)));
    if (std::isnan(errors[f])) errors[f] = std::numeric_limits<double>::infinity();
  }
  return errors;
}

std::vector<double> errors_of(const Scene& scene, const Truth& truth,
                              const std::vector<std::vector<double>>& states) {
  std::vector<double> worst(truth.fields.size(), 0.0);
  for (std::size_t output = 0; output < states.size(); ++output) {
    const auto errors = errors_at(scene, truth, output, states[output]);
    for (std::size_t f = 0; f < worst.size(); ++f) worst[f] = std::max(worst[f], errors[f]);
  }
  return worst;
}

Row judge(const StatedScene& stated, const Scene& scene, const Truth& truth, const Contender& contender,
          double rtol, const AuditSettings& settings, TimeLimit& limit) {
  Row row{.seed = stated.seed, .kind = stated.kind, .shape = stated.shape, .unknowns = scene.rhs->size()};
  row.t_lambda = stated.t_lambda;
  row.label = contender.label;
  row.rtol = contender.adaptive ? rtol : 0;
  bool anything_moves = false;
  for (std::size_t f = 0; f < truth.fields.size(); ++f) {
    if (!is_judged(scene, truth, f)) continue;
    anything_moves = true;
    row.floored = row.floored || row.rtol * truth.fields[f].span() < rounding_floor(truth.fields[f]);
  }
  Score score;
  RunRequest request;
  if (settings.true_spans) request.spans = true_spans(scene, truth);
  request.observe = [&](std::size_t, double, std::span<const double> state) {
    add_output(scene, truth, row.rtol, state, score);
  };
  request.stop = limit.begin();
  const RunResult run = run_one(scene, contender.spec(rtol), request);
  const bool was_stopped = limit.end();
  row.status = status_name(run.outcome.status);
  row.reason = run.outcome.reason;
  if (was_stopped && run.outcome.status == Status::interrupted) {
    row.status = "timeout";
    row.reason =
        fmt::format("more than {:g} s for {:.3g} of the run", limit.seconds(), run.t_reached / stated.t_end);
  }
  row.steps = run.statistics.steps;
  row.rejected = run.statistics.rejected;
  row.sweeps = run.sweeps;
  row.seconds = run.cpu_prepare + run.cpu_stepping;
  if (score.outputs < scene.output_times.size() || !anything_moves) return row;
  row.error = score.error;
  if (contender.adaptive) row.delivered = score.delivered;
  return row;
}

}  // namespace superstep::audit
