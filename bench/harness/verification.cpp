#include "bench/harness/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/measure/metrics.hpp"
#include "bench/measure/range_watch.hpp"
#include "bench/measure/run_one.hpp"
#include "bench/measure/scene_facts.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

constexpr double most_tolerances = 10;  // a method whose error is more than so many tolerances is inaccurate

void keep_larger(Number& kept, double value) {
  kept = std::max(kept.value_or(0.0), value);
}

/// What entered along the reference against what the run has stored; of the main field only: with two fields,
/// heat in the temperature.
Number balance_of(const Scene& scene, std::size_t f, std::span<const double> last,
                  const Reference& reference) {
  if (f != main_field(*scene.rhs)) return std::nullopt;
  const FieldView& field = scene.rhs->fields()[f];
  const auto capacities = scene.rhs->capacities();
  double scale = 0;
  for (std::size_t k = 0, i = field.offset; k < field.count; ++k, i += field.stride)
    scale += capacities[i] * reference.spans[f];
  return balance(reference.inflow, stored(field, capacities, scene.initial, last), scale);
}

}  // namespace

double allowed_error(const Scene& scene, const FieldView& field, double rtol, double span) {
  constexpr double roundings = 100;
  const FieldScene& described = scene_field(scene, field.name);
  const double magnitude = std::max(std::abs(described.low), std::abs(described.high)) + span;
  return std::max(rtol * span, roundings * std::numeric_limits<double>::epsilon() * magnitude);
}

OutputErrors::OutputErrors(const Scene& scene, const Reference* reference)
    : scene_(scene), reference_(reference), errors_(scene.rhs->fields().size()) {
  for (std::size_t f = 0; reference && f < errors_.size(); ++f) errors_[f].span = reference->spans[f];
}

void OutputErrors::observe(std::size_t output, double t, std::span<const double> state) {
  const auto fields = scene_.rhs->fields();
  for (std::size_t f = 0; f < fields.size(); ++f) {
    keep_larger(errors_[f].overshoot, overshoot_at(scene_, f, t, state));
    if (!reference_) continue;
    const Deviation difference = deviation(fields[f], state, reference_->states[output]);
    keep_larger(errors_[f].rms, difference.rms);
    keep_larger(errors_[f].max, difference.max);
    const double span = reference_->spans[f];
    if (!(span > 0)) continue;
    const bool is_cvode = reference_->cvode.empty();  // the reference itself
    const auto& cvode = is_cvode ? reference_->states[output] : reference_->cvode[output];
    keep_larger(errors_[f].distance_to_cvode, deviation(fields[f], state, cvode).rms / span);
  }
  last_.assign(state.begin(), state.end());
}

void OutputErrors::judge_besides(std::size_t field, Outcome& outcome) const {
  const auto fields = scene_.rhs->fields();
  for (std::size_t f = 0; f < fields.size(); ++f) {
    FieldErrors errors = errors_[f];
    errors.relative_rms =
        f != field && errors.rms && *errors.span > 0 ? Number(*errors.rms / *errors.span) : std::nullopt;
    judge(errors, fields[f].name, fields[f].unit, outcome);
  }
}

void judge_range(const Scene& scene, const RunResult& run, Outcome& outcome) {
  const auto fields = scene.rhs->fields();
  for (std::size_t f = 0; f < run.overshoot.size(); ++f) {
    FieldErrors errors;
    errors.overshoot = run.overshoot[f];
    // Nobody has looked for spans on behalf of a method without a tolerance.
    errors.span =
        f < run.spans.size() ? run.spans[f] : scene_field(scene, fields[f].name).range_of_state().span();
    judge(errors, fields[f].name, fields[f].unit, outcome);
  }
}

Number delivered_error(double rms, double bar, double allowed) {
  const double limit = most_tolerances * allowed;
  const bool told = rms + bar <= limit || rms - bar > limit;
  return told ? Number(rms / allowed) : std::nullopt;
}

void judge(const FieldErrors& errors, const std::string& field, const std::string& unit, Outcome& outcome) {
  constexpr double part_of_span = 0.1;
  if (!errors.span || !(*errors.span > 0)) return;
  if (errors.relative_rms && *errors.relative_rms > part_of_span)
    outcome = {Status::inaccurate,
               fmt::format("the {} is off by {:.3g} {} rms, {:.0f} % of its span of "
                           "{:.3g} {}: take shorter steps or a tighter tolerance",
                           field, *errors.rms, unit, 100 * *errors.relative_rms, *errors.span, unit)};
  else if (errors.delivered && *errors.delivered > most_tolerances)
    outcome = {Status::inaccurate, fmt::format("the error of the {} is {:.3g} times what was asked for",
                                               field, *errors.delivered)};
  else if (errors.overshoot && *errors.overshoot > part_of_span * *errors.span)
    outcome = {Status::inaccurate, fmt::format("the {} leaves the range that it can take by {:.3g} {}", field,
                                               *errors.overshoot, unit)};
}

void measure_probe_errors(const ProbeHistory& run, const ProbeHistory& reference, std::size_t slot,
                          double t_end, FieldErrors& errors) {
  const double last = reference.at(t_end, slot);
  double largest = 0;
  for (std::size_t k = 0; k < reference.size() && reference.time(k) <= t_end; ++k)
    largest = std::max(largest, std::abs(reference.value(k, slot) - last));
  std::vector<double> time, error, distance;
  for (std::size_t k = 1; k < run.size() && run.time(k) <= t_end; ++k) {  // 0 is the initial state
    const double expected = reference.at(run.time(k), slot);
    time.push_back(run.time(k));
    error.push_back(std::abs(run.value(k, slot) - expected));
    distance.push_back(std::abs(expected - last));
  }
  if (time.empty()) return;
  const std::size_t length = transient_length(distance, largest);
  time.resize(length);
  error.resize(length);
  double sum = 0;
  for (const double e : error) sum += e;
  errors.probe_mean = sum / static_cast<double>(length);
  // An error grows from 0 before it decays: the fit begins at its maximum.
  const auto largest_error =
      static_cast<std::size_t>(std::max_element(error.begin(), error.end()) - error.begin());
  const std::span<const double> times(time), errors_at(error);
  if (const auto fit = fit_decay(times.subspan(largest_error), errors_at.subspan(largest_error))) {
    errors.decay_rate = fit->rate;
    errors.decay_r2 = fit->r2;
  }
}

Verification verify(const Scene& scene, const ProbeSet& probes, const MethodSpec& spec,
                    const Reference* reference, const std::atomic<bool>* stop, Progress* progress,
                    const RunLimits& limits) {
  Verification result;
  OutputErrors outputs(scene, reference);
  RunRequest request{.spans = reference ? reference->spans : std::vector<double>{},
                     .probes = &probes,
                     .stop = stop,
                     .progress = progress,
                     .limits = limits};
  request.observe = [&](std::size_t k, double t, std::span<const double> state) {
    outputs.observe(k, t, state);
  };
  const RunResult run = run_one(scene, spec, request);
  result.outcome = run.outcome;
  result.history = run.history;
  if (!run.outcome.ok()) return result;
  result.errors = outputs.errors();
  const auto fields = scene.rhs->fields();
  const double rtol = spec.rtol();
  for (std::size_t f = 0; f < fields.size(); ++f) {
    FieldErrors& errors = result.errors[f];
    if (!reference) continue;
    const double span = reference->spans[f];
    errors.balance = balance_of(scene, f, outputs.last(), *reference);
    errors.reference_error = reference->error_bar[f];
    if (span > 0) errors.relative_rms = *errors.rms / span;
    if (span > 0 && rtol > 0)
      errors.delivered =
          delivered_error(*errors.rms, reference->error_bar[f], allowed_error(scene, fields[f], rtol, span));
    const ProbeColumn* probe = probes.first_in(fields[f].name);
    if (probe)
      measure_probe_errors(run.history, reference->history, static_cast<std::size_t>(probe->slot),
                           scene.t_end, errors);
  }
  for (std::size_t f = 0; f < result.errors.size(); ++f)
    judge(result.errors[f], fields[f].name, fields[f].unit, result.outcome);
  return result;
}

}  // namespace superstep
