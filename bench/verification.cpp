#include "bench/verification.hpp"

#include <algorithm>
#include <cmath>

#include "bench/metrics.hpp"
#include "bench/run_one.hpp"
#include "bench/scene_facts.hpp"

namespace superstep {
namespace {

void keep_larger(Number& kept, double value) {
  kept = std::max(kept.value_or(0.0), value);
}

/// Range of a field [K or V]: initial and fixed values, and what the reference computed.
FieldRange range_of(const Scene& scene, const FieldView& field, const Reference* reference) {
  const FieldScene& described = scene_field(scene, field.name);
  FieldRange range{described.low, described.high};
  if (!reference) return range;
  for (const auto& state : reference->states)
    for (std::size_t k = 0, i = field.offset; k < field.count; ++k, i += field.stride) {
      range.low = std::min(range.low, state[i]);
      range.high = std::max(range.high, state[i]);
    }
  return range;
}

/// Collects the errors at output times while the run goes on, so that no state has to be kept.
class OutputErrors {
 public:
  OutputErrors(const Scene& scene, const Reference* reference, std::vector<FieldErrors>& errors)
      : scene_(scene), reference_(reference), errors_(errors) {
    errors_.resize(scene.rhs->fields().size());
  }

  void observe(std::size_t output, double t, std::span<const double> state) {
    const auto fields = scene_.rhs->fields();
    for (std::size_t f = 0; f < fields.size(); ++f) {
      const double widened = scene_.rhs->source_rate(f) * t;
      const FieldScene& described = scene_field(scene_, fields[f].name);
      keep_larger(errors_[f].overshoot,
                  overshoot(fields[f], state, described.low - widened, described.high + widened));
      if (!reference_) continue;
      const Deviation difference = deviation(fields[f], state, reference_->states[output]);
      keep_larger(errors_[f].rms, difference.rms);
      keep_larger(errors_[f].max, difference.max);
    }
    last_.assign(state.begin(), state.end());
  }

  [[nodiscard]] std::span<const double> last() const noexcept { return last_; }

 private:
  const Scene& scene_;
  const Reference* reference_;
  std::vector<FieldErrors>& errors_;
  std::vector<double> last_;
};

// `Statistics::inflow` belongs to the main field: with two fields, what enters the temperature.
Number balance_of(const Scene& scene, std::size_t f, std::span<const double> last, double entered,
                  double span) {
  if (f != main_field(*scene.rhs)) return std::nullopt;
  const FieldView& field = scene.rhs->fields()[f];
  const auto capacities = scene.rhs->capacities();
  double scale = 0;
  for (std::size_t k = 0, i = field.offset; k < field.count; ++k, i += field.stride)
    scale += capacities[i] * span;
  return balance(entered, stored(field, capacities, scene.initial, last), scale);
}

}  // namespace

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

Verification verify(const Scene& scene, const ProbeSet& probes, const std::string& spec,
                    const Reference* reference, const std::atomic<bool>* stop, Progress* progress) {
  Verification result;
  OutputErrors outputs(scene, reference, result.errors);
  RunRequest request{.track_inflow = true, .probes = &probes, .stop = stop, .progress = progress};
  request.observe = [&](std::size_t k, double t, std::span<const double> state) {
    outputs.observe(k, t, state);
  };
  const RunResult run = run_one(scene, spec, request);
  result.outcome = run.outcome;
  result.history = run.history;
  if (!run.outcome.ok()) {
    result.errors.clear();
    return result;
  }
  const auto fields = scene.rhs->fields();
  for (std::size_t f = 0; f < fields.size(); ++f) {
    FieldErrors& errors = result.errors[f];
    const double span = range_of(scene, fields[f], reference).span();
    errors.balance = balance_of(scene, f, outputs.last(), run.statistics.inflow, span);
    if (!reference) continue;
    if (span > 0) errors.relative_rms = *errors.rms / span;
    if (!reference->error_bar.empty()) errors.reference_error = reference->error_bar[f];
    const ProbeColumn* probe = probes.first_in(fields[f].name);
    if (probe)
      measure_probe_errors(run.history, reference->history, static_cast<std::size_t>(probe->slot),
                           scene.t_end, errors);
  }
  return result;
}

}  // namespace superstep
