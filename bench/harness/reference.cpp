#include "bench/harness/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/harness/reference_cache.hpp"
#include "bench/harness/reference_pair.hpp"
#include "bench/host/machine.hpp"
#include "bench/host/watchdog.hpp"
#include "bench/measure/metrics.hpp"
#include "bench/measure/run_one.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/stopwatch.hpp"
#include "core/text/options.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

// Raised when the same scene and SPEC give other numbers than before, or the meaning of the cached numbers
// changes.
constexpr int reference_code_version = 7;

/// Empty for a scene without a hash: nothing names what its answer depends on. Networks are added
/// for the sake of generated packings, which differ between compilers.
std::string cache_key(const Scene& scene, const std::string& spec) {
  if (scene.content_hash.empty()) return {};
  ContentHash hash;
  hash.add_number(reference_code_version).add(program_version()).add(spec).add(scene.content_hash);
  hash.add_number(scene.t_end).add_all<double>(scene.output_times).add_all<double>(scene.initial);
  for (const auto& field : scene.fields)
    hash.add_all<double>(field.graph.capacity).add_all<double>(field.graph.conductance);
  return hash.text();
}

bool fits(const CachedReference& cached, const Scene& scene, const ProbeSet& probes) {
  const std::size_t fields = scene.rhs->fields().size(), size = scene.rhs->size();
  const auto whole = [size](const auto& states) {
    return std::all_of(states.begin(), states.end(), [size](const auto& s) { return s.size() == size; });
  };
  return cached.states.size() == scene.output_times.size() && whole(cached.states) && whole(cached.cvode) &&
         cached.error_bar.size() == fields && cached.spans.size() == fields && cached.scalars.size() == 2 &&
         cached.history.probes() == probes.entries().size() &&
         (probes.entries().empty() || cached.history.size() > 0);
}

std::optional<Reference> from_cache(const std::string& file, const Scene& scene, const ProbeSet& probes) {
  auto cached = read_cached_reference(file);
  if (!cached || !fits(*cached, scene, probes)) return std::nullopt;
  Reference reference;
  reference.states = std::move(cached->states);
  reference.cvode = std::move(cached->cvode);
  reference.error_bar = std::move(cached->error_bar);
  reference.spans = std::move(cached->spans);
  reference.inflow = cached->scalars[0];
  reference.cpu_pilot = cached->scalars[1];
  reference.history = std::move(cached->history);
  reference.from_cache = true;
  return reference;
}

/// Two families, one after the other, and what their distance says.
class ReferenceSearch {
 public:
  ReferenceSearch(const Scene& scene, const ProbeSet& probes, const ReferenceRequest& wanted,
                  Progress& progress)
      : scene_(scene), probes_(probes), wanted_(wanted), progress_(progress), pair_(reference_pair(scene)) {
    if (wanted.spec.empty() || wanted.spec == pair_.truth.text()) return;
    const MethodSpec truth(wanted.spec);
    pair_ = {truth, check_of(scene, truth), truth.name() == "exponential" && is_one_linear_field(scene)};
  }

  ReferenceResult run() {
    ReferenceResult result;
    result.outcome = find_spans_of_scene();
    if (!result.outcome.ok()) return result;
    reference_.spec = pair_.truth.text();
    Run truth = integrate(pair_.truth);
    result.outcome = truth.outcome;
    if (!truth.outcome.ok()) return result;
    pair_.certified = pair_.certified && truth.bounded;
    Run check = integrate(pair_.check);
    if (check.outcome.status == Status::interrupted) {
      result.outcome = check.outcome;
      return result;
    }
    reference_.check = pair_.check.text();
    if (check.outcome.ok()) {
      set_error_bar(truth, check, result.warnings);
    } else {
      result.warnings.push_back(
          fmt::format("the reference is not checked: {}: {}", pair_.check.text(), check.outcome.reason));
      reference_.error_bar = truth.bound;
      for (double& bar : reference_.error_bar)
        if (!pair_.certified) bar = std::numeric_limits<double>::infinity();
    }
    // CVODE knows what the probes were between its steps.
    const bool by_check = pair_.certified && check.outcome.ok();
    reference_.history = std::move(by_check ? check.history : truth.history);
    if (by_check) reference_.cvode = std::move(check.states);
    reference_.states = std::move(truth.states);
    reference_.inflow = truth.inflow;
    result.reference = std::move(reference_);
    return result;
  }

 private:
  struct Run {
    Outcome outcome;
    std::vector<std::vector<double>> states;
    std::vector<double> bound;  ///< [fields]
    bool bounded = false;       ///< by the method itself, not by rounding alone
    ProbeHistory history;
    double inflow = 0;
  };

  /// A pilot run takes its time, too.
  Outcome find_spans_of_scene() {
    const double begin = process_cpu_seconds();
    const RunLimits& limits = wanted_.limits;
    const Watchdog dog(limits.seconds, wanted_.stop, limits.of_cpu);
    progress_.begin("span of the fields", scene_.t_end);
    const Spans found = scene_spans(scene_, dog.flag());
    progress_.end();
    if (dog.time_is_up())
      return {Status::timeout,
              fmt::format("the span of the fields is not found after {:g} s of {} time; allow it "
                          "more with --time-limit",
                          limits.seconds, limits.of_cpu ? "CPU" : "wall")};
    reference_.spans = found.spans;
    reference_.spans_how = found.how;
    if (found.pilot) reference_.cpu_pilot = process_cpu_seconds() - begin;
    return {};
  }

  Run integrate(const MethodSpec& spec) {
    Run run;
    RunRequest request{.track_inflow = true,
                       .spans = reference_.spans,
                       .probes = &probes_,
                       .stop = wanted_.stop,
                       .progress = &progress_,
                       .limits = wanted_.limits};
    request.observe = [&](std::size_t, double, std::span<const double> state) {
      run.states.emplace_back(state.begin(), state.end());
    };
    progress_.begin("reference " + spec.text(), scene_.t_end);
    RunResult result = run_one(scene_, spec, request);
    progress_.end();
    reference_.cpu_seconds += result.cpu_prepare + result.cpu_stepping;
    run.outcome = result.outcome;
    run.history = std::move(result.history);
    run.inflow = result.statistics.inflow;
    run.bounded = result.statistics.error_bound > 0;
    for (std::size_t f = 0; f < reference_.spans.size(); ++f) {
      const double bound = result.statistics.error_bound, stored = bound > 0 ? 1 : roundings;
      run.bound.push_back(bound * reference_.spans[f] +
                          stored * std::numeric_limits<double>::epsilon() * largest_value(f));
    }
    return run;
  }

  [[nodiscard]] double largest_value(std::size_t f) const {
    const FieldScene& field = scene_field(scene_, scene_.rhs->fields()[f].name);
    return std::max(std::abs(field.low), std::abs(field.high)) + reference_.spans[f];
  }

  void set_error_bar(const Run& truth, const Run& check, std::vector<std::string>& warnings) {
    constexpr double reserve = 1.5;  // both may err to the same side
    const auto fields = scene_.rhs->fields();
    for (std::size_t f = 0; f < fields.size(); ++f) {
      double distance = 0;
      for (std::size_t k = 0; k < truth.states.size(); ++k)
        distance = std::max(distance, deviation(fields[f], check.states[k], truth.states[k]).rms);
      // A method's own tolerance, or where that is more, a hundred roundings of the values.
      const double tolerance = std::max(pair_.check.rtol() * reference_.spans[f],
                                        100 * std::numeric_limits<double>::epsilon() * largest_value(f));
      constexpr double proportional = 10;  // times its tolerance, which is what any method may miss by
      if (pair_.certified && distance <= proportional * tolerance + truth.bound[f]) {
        reference_.error_bar.push_back(truth.bound[f]);
        continue;
      }
      if (pair_.certified)
        warnings.push_back(
            fmt::format("{} and {} differ by {:.2g} {} in the {}, more than they should: that is "
                        "how well the reference is known",
                        pair_.truth.text(), pair_.check.text(), distance, fields[f].unit, fields[f].name));
      // Nor is a solution better known than twice the tolerance that it was computed with.
      const double own = pair_.certified ? 0 : 2 * pair_.truth.rtol() * reference_.spans[f];
      reference_.error_bar.push_back(std::max(reserve * distance, own) + truth.bound[f]);
    }
  }

  static constexpr double roundings = 10;  // of values, where a run has no bound that counts its own

  const Scene& scene_;
  const ProbeSet& probes_;
  const ReferenceRequest& wanted_;
  Progress& progress_;
  ReferencePair pair_;
  Reference reference_;
};

}  // namespace

ReferenceResult obtain_reference(const Scene& scene, const ProbeSet& probes, const ReferenceRequest& request,
                                 Progress& progress) {
  const std::string spec = request.spec.empty() ? reference_pair(scene).truth.text() : request.spec;
  const std::string key = request.use_cache ? cache_key(scene, spec) : std::string{};
  const std::string file = key.empty() ? std::string{} : cache_file(key);
  ReferenceResult result;
  if (!file.empty()) result.reference = from_cache(file, scene, probes);
  if (!result.reference) result = ReferenceSearch(scene, probes, request, progress).run();
  if (!result.reference) return result;
  if (result.reference->from_cache) result.reference->spec = spec;
  if (result.reference->from_cache || file.empty()) return result;
  try {
    write_cached_reference(file, {.states = result.reference->states,
                                  .cvode = result.reference->cvode,
                                  .error_bar = result.reference->error_bar,
                                  .spans = result.reference->spans,
                                  .scalars = {result.reference->inflow, result.reference->cpu_pilot},
                                  .history = result.reference->history});
  } catch (const OutputError& error) {
    result.warnings.push_back(fmt::format("the reference is not cached: {}", error.what()));
  }
  return result;
}

}  // namespace superstep
