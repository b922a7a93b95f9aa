#include "bench/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bench/digest.hpp"
#include "bench/machine.hpp"
#include "bench/metrics.hpp"
#include "bench/reference_cache.hpp"
#include "bench/run_one.hpp"
#include "bench/spec_settings.hpp"
#include "core/error.hpp"
#include "core/options.hpp"
#include "rhs/one_way.hpp"

namespace superstep {
namespace {

// Raised when the same scene and SPEC give other numbers than before, or the meaning of the cached numbers
// changes.
constexpr int reference_code_version = 3;

std::string cache_key(const Scene& scene, const std::string& spec) {
  Digest digest;
  digest.add_number(reference_code_version).add(program_version()).add(spec);
  add_scene(digest, scene);
  return digest.text();
}

bool fits(const CachedReference& cached, const Scene& scene, const ProbeSet& probes) {
  const std::size_t fields = scene.rhs->fields().size(), size = scene.rhs->size();
  return cached.states.size() == scene.output_times.size() &&
         std::all_of(cached.states.begin(), cached.states.end(),
                     [&](const auto& s) { return s.size() == size; }) &&
         (cached.error_bar.empty() || cached.error_bar.size() == fields) &&
         cached.history.probes() == probes.entries().size() &&
         (probes.entries().empty() || cached.history.size() > 0);
}

std::optional<Reference> from_cache(const std::string& file, const Scene& scene, const ProbeSet& probes) {
  auto cached = read_cached_reference(file);
  if (!cached || !fits(*cached, scene, probes)) return std::nullopt;
  Reference reference;
  reference.states = std::move(cached->states);
  reference.error_bar = std::move(cached->error_bar);
  reference.history = std::move(cached->history);
  reference.from_cache = true;
  return reference;
}

RunResult integrate(const Scene& scene, const std::string& spec, RunRequest request, Reference& reference) {
  request.progress->begin("reference " + spec, scene.t_end);
  RunResult run = run_one(scene, spec, request);
  request.progress->end();
  reference.cpu_seconds += run.cpu_prepare + run.cpu_stepping;
  return run;
}

// Runs the other method and keeps its largest distance to the reference, field by field.
Outcome measure_error_bar(const Scene& scene, const std::string& spec, RunRequest request,
                          Reference& reference) {
  const auto fields = scene.rhs->fields();
  std::vector<double> bar(fields.size(), 0.0);
  request.probes = nullptr;
  request.observe = [&](std::size_t k, double, std::span<const double> state) {
    for (std::size_t f = 0; f < fields.size(); ++f)
      bar[f] = std::max(bar[f], deviation(fields[f], state, reference.states[k]).rms);
  };
  Outcome outcome = integrate(scene, spec, request, reference).outcome;
  if (outcome.ok()) reference.error_bar = std::move(bar);
  return outcome;
}

// What the reference is compared with: the exponential where it is exact, else the same method 10 times
// looser.
std::optional<std::string> cross_check(const Scene& scene, const std::string& spec) {
  if (exactly_solvable(*scene.rhs) && parse_spec(spec).name != "exponential") return "exponential:rtol=1e-14";
  return loosened(spec);
}

ReferenceResult compute(const Scene& scene, const ProbeSet& probes, const ReferenceRequest& wanted,
                        Progress& progress) {
  ReferenceResult result;
  Reference reference;
  RunRequest request{.probes = &probes, .stop = wanted.stop, .progress = &progress};
  request.observe = [&](std::size_t, double, std::span<const double> state) {
    reference.states.emplace_back(state.begin(), state.end());
  };
  RunResult run = integrate(scene, wanted.spec, request, reference);
  result.outcome = run.outcome;
  if (!run.outcome.ok()) return result;
  reference.history = std::move(run.history);
  if (const auto check = cross_check(scene, wanted.spec)) {
    const Outcome outcome = measure_error_bar(scene, *check, request, reference);
    if (outcome.status == Status::interrupted) {
      result.outcome = outcome;
      return result;
    }
    if (!outcome.ok())
      result.warnings.push_back(
          fmt::format("the reference has no error bar: {}: {}", *check, outcome.reason));
  }
  result.reference = std::move(reference);
  return result;
}

}  // namespace

std::string default_reference(const Scene& scene) {
  // A factorization of a cube of 93 000 nodes takes more than ten thousand sweeps.
  constexpr std::size_t most_for_klu = 50'000;  // unknowns
  if (scene.rhs->size() <= most_for_klu) return "cvode:rtol=1e-9,linsol=klu";
  return exactly_solvable(*scene.rhs) ? "exponential:rtol=1e-14" : "cvode:rtol=1e-9";
}

ReferenceResult obtain_reference(const Scene& scene, const ProbeSet& probes, const ReferenceRequest& request,
                                 Progress& progress) {
  const std::string file = request.use_cache ? cache_file(cache_key(scene, request.spec)) : std::string{};
  ReferenceResult result;
  if (!file.empty()) result.reference = from_cache(file, scene, probes);
  if (!result.reference) result = compute(scene, probes, request, progress);
  if (!result.reference) return result;
  result.reference->spec = request.spec;
  if (result.reference->from_cache || file.empty()) return result;
  try {
    write_cached_reference(
        file, {result.reference->states, result.reference->error_bar, result.reference->history});
  } catch (const OutputError& error) {
    result.warnings.push_back(fmt::format("the reference is not cached: {}", error.what()));
  }
  return result;
}

}  // namespace superstep
