#include "bench/harness/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/harness/harness.hpp"
#include "bench/harness/reference.hpp"
#include "bench/harness/verification.hpp"
#include "bench/measure/metrics.hpp"
#include "bench/measure/probe_set.hpp"
#include "bench/measure/run_one.hpp"
#include "bench/measure/scene_facts.hpp"
#include "core/error.hpp"
#include "integrators/registry.hpp"
#include "rhs/one_way.hpp"

namespace superstep {
namespace {

/// A run to the end is timed however wrong it is.
bool is_timed(const WorkPrecisionPoint& point) {
  return point.ok() || point.status == status_name(Status::inaccurate);
}

class Sweep {
 public:
  Sweep(const Scene& scene, const WorkPrecisionOptions& options, Progress& progress)
      : scene_(scene),
        options_(options),
        progress_(progress),
        field_(scene.rhs->fields()[main_field(*scene.rhs)]) {}

  WorkPrecision run() {
    describe();
    find_reference();
    const auto specs = options_.integrators.empty() ? work_precision_specs() : options_.integrators;
    for (const auto& spec : specs) enter(spec);
    times_.resize(study_.points.size());
    for (int round = 0; round < options_.repetitions; ++round)
      for (const std::size_t k : round_order(study_.points.size(), static_cast<std::size_t>(round)))
        if (!stopped()) measure(k, round == 0);
    for (std::size_t k = 0; k < times_.size(); ++k)
      if (is_timed(study_.points[k]) && !times_[k].empty()) study_.points[k].cpu = summarize(times_[k]);
    std::erase_if(study_.points, [](const auto& point) { return point.status.empty(); });  // never started
    return std::move(study_);
  }

 private:
  [[nodiscard]] bool stopped() const noexcept { return options_.stop && options_.stop->load(); }

  void describe() {
    study_.case_name = scene_.name;
    study_.title = scene_.title;
    study_.unit = field_.unit;
    study_.unknowns = scene_.rhs->size();
    study_.repetitions = options_.repetitions;
    study_.threads = options_.threads;
    study_.output_times = scene_.output_times;
  }

  void find_reference() {
    const ProbeSet probes(scene_);
    auto result = obtain_reference(
        scene_, probes,
        {options_.reference, options_.use_cache, options_.stop, limits_of_reference(options_.limits)},
        progress_);
    if (!result.reference)
      throw NumericalError(fmt::format("the reference did not succeed: {}", result.outcome.reason));
    reference_ = std::move(*result.reference);
    const std::size_t field = main_field(*scene_.rhs);
    study_.reference = reference_.spec;
    study_.reference_error = reference_.error_bar[field];
    study_.span = reference_.spans[field];
    if (scene_.rhs->reduction().total() == 0 || !(study_.span > 0))
      throw NumericalError(
          fmt::format("nothing moves in the {} of {}: there is no error to measure work against", field_.name,
                      scene_.file));
  }

  void enter(const std::string& spec) {
    const Spec parsed = parse_spec(spec);
    WorkPrecisionPoint point;
    point.family = family_of(parsed);
    point.spec = spec;
    point.integrator = parsed.name;
    point.params = parsed.parameters();
    study_.points.push_back(std::move(point));
  }

  void measure(std::size_t k, bool first) {
    WorkPrecisionPoint& point = study_.points[k];
    if (!first && !is_timed(point)) return;
    progress_.begin(fmt::format("{} of {} {}", k + 1, study_.points.size(), point.spec), scene_.t_end);
    RunRequest request{
        .spans = reference_.spans, .stop = options_.stop, .progress = &progress_, .limits = options_.limits};
    std::vector<double> errors;
    OutputErrors all(scene_, &reference_);
    if (first)
      request.observe = [&](std::size_t output, double t, std::span<const double> state) {
        errors.push_back(deviation(field_, state, reference_.states[output]).rms);
        all.observe(output, t, state);
      };
    const RunResult run = run_one(scene_, point.spec, request);
    progress_.end();
    if (run.outcome.status == Status::interrupted) return;
    if (first || !run.outcome.ok()) {
      Outcome outcome = run.outcome;
      if (outcome.ok()) all.judge_besides(main_field(*scene_.rhs), outcome);
      point.status = status_name(outcome.status);
      point.reason = outcome.reason;
    }
    point.sweeps = run.sweeps;
    point.steps = run.statistics.steps;
    if (!run.outcome.ok()) return;
    times_[k].push_back(run.cpu_prepare + run.cpu_stepping);
    if (!first) return;
    point.error_rms = errors;
    point.worst = *std::max_element(errors.begin(), errors.end());
    point.worst_relative = point.worst / study_.span;
  }

  const Scene& scene_;
  const WorkPrecisionOptions& options_;
  Progress& progress_;
  FieldView field_;
  Reference reference_;
  WorkPrecision study_;
  std::vector<std::vector<double>> times_;
};

}  // namespace

std::vector<std::string> work_precision_specs() {
  std::vector<std::string> specs;
  for (const auto& entry : integrators()) specs.insert(specs.end(), entry.ladder.begin(), entry.ladder.end());
  return specs;
}

WorkPrecision work_precision(const Scene& scene, const WorkPrecisionOptions& options, Progress& progress) {
  return Sweep(scene, options, progress).run();
}

}  // namespace superstep
