#include "bench/harness/harness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "bench/harness/instructions.hpp"
#include "bench/harness/observations.hpp"
#include "bench/harness/verification.hpp"
#include "bench/host/machine.hpp"
#include "bench/host/yardstick.hpp"
#include "bench/measure/joule_cost.hpp"
#include "bench/measure/run_one.hpp"
#include "bench/measure/sampled_errors.hpp"
#include "bench/measure/scene_facts.hpp"
#include "core/shared_library.hpp"
#include "core/stopwatch.hpp"

namespace superstep {
namespace {

/// One method on its way through the benchmark.
struct Contender {
  BenchRow row;
  MethodSpec method;
  Outcome outcome = {};
  bool verified = false;
  double time_per_sweep = 0;  ///< s
  std::vector<double> cpu_total = {}, cpu_prepare = {}, cpu_stepping = {}, wall_stepping = {}, yardstick = {};
  std::vector<double> samples = {};  ///< at the instants of a published table [K or V]
};

/// A run to the end is timed however wrong it is.
bool is_timed(const Outcome& outcome) noexcept {
  return outcome.ok() || outcome.status == Status::inaccurate;
}

class CaseBench {
 public:
  CaseBench(const Scene& scene, double cpu_setup, const HarnessOptions& options, Progress& progress)
      : scene_(scene),
        cpu_setup_(cpu_setup),
        options_(options),
        progress_(progress),
        probes_(scene),
        sampled_(options.sampled, probes_),
        joule_cost_(scene) {}

  BenchCase run() {
    BenchCase out = describe();
    for (const auto& spec : contenders(scene_.bench, options_.integrators))
      contenders_.push_back({.row = begin_row(out, spec, options_.threads), .method = spec});
    find_reference(out);
    for (auto& contender : contenders_) verify_one(contender);
    for (auto& contender : contenders_) warm_up(contender);
    if (options_.count_instructions)
      for (auto& contender : contenders_) count(contender, out);
    timing_began_ = wall_seconds();
    for (int round = 0; round < options_.repetitions; ++round) time_round(static_cast<std::size_t>(round));
    finish(out);
    out.observations = std::move(observations_);
    return out;
  }

 private:
  [[nodiscard]] BenchCase describe() const;
  void find_reference(BenchCase& out);
  void refuse_to_rank_blindly(BenchCase& out);
  [[nodiscard]] std::vector<double> spans() const {
    return reference_ ? reference_->spans : std::vector<double>{};
  }
  void verify_one(Contender& contender);
  void warm_up(Contender& contender);
  void count(Contender& contender, BenchCase& out);
  void time_round(std::size_t round);
  void time_one(Contender& contender);
  void compare_as_published();
  void compare_with_theory();
  void finish(BenchCase& out);
  void fail(Contender& contender, const Outcome& outcome) const;
  [[nodiscard]] bool stopped() const noexcept { return options_.stop && options_.stop->load(); }
  [[nodiscard]] std::string position(const Contender& contender) const;

  const Scene& scene_;
  double cpu_setup_;
  const HarnessOptions& options_;
  Progress& progress_;
  ProbeSet probes_;
  SampledErrors sampled_;
  JouleCost joule_cost_;
  Yardstick yardstick_;
  std::optional<Reference> reference_;
  std::vector<Contender> contenders_;
  CaseObservations observations_;
  double timing_began_ = 0;  // wall clock [s]
  std::size_t timed_runs_ = 0;
  std::vector<double> cpu_joule_;  // one a round [s]
};

BenchCase CaseBench::describe() const {
  BenchCase out = begin_case(scene_);
  out.nodes = scene_.nodes();
  out.contacts = scene_.fields.front().graph.edges();
  out.unknowns = scene_.rhs->size();
  out.cpu_setup = cpu_setup_;
  out.unit = scene_.rhs->fields()[main_field(*scene_.rhs)].unit;
  out.warnings = scene_.warnings;
  out.skips = skipped_work(scene_);
  out.sampled = options_.sampled;
  return out;
}

void CaseBench::find_reference(BenchCase& out) {
  if (options_.reference == "none") return;
  auto result = obtain_reference(
      scene_, probes_,
      {options_.reference, options_.use_cache, options_.stop, limits_of_reference(options_.limits)},
      progress_);
  out.warnings.insert(out.warnings.end(), result.warnings.begin(), result.warnings.end());
  reference_ = std::move(result.reference);
  if (reference_ && scene_.packed) observations_.slice = slice_of(scene_, *reference_);
  if (reference_)
    out.reference = ReferenceFacts{reference_->spec, reference_->from_cache, reference_->cpu_seconds};
  else if (!stopped())
    out.warnings.push_back(
        fmt::format("no errors are measured: the reference did not succeed: {}", result.outcome.reason));
  if (reference_) refuse_to_rank_blindly(out);
}

// A reference that is known less well than loose methods are good for cannot say which of them is right.
void CaseBench::refuse_to_rank_blindly(BenchCase& out) {
  constexpr double loosest_use = 1e-2;
  const auto fields = scene_.rhs->fields();
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const double span = reference_->spans[f], bar = reference_->error_bar[f];
    if (!(span > 0) || bar <= loosest_use * span) continue;
    out.warnings.push_back(
        fmt::format("no errors are measured: {} and {} agree on the {} only to {:.2g} of its span",
                    reference_->spec, reference_->check, fields[f].name, bar / span));
    out.reference.reset();
    reference_.reset();
    return;
  }
}

// "3 of 7 sts:n=20": which method is on.
std::string CaseBench::position(const Contender& contender) const {
  return fmt::format("{} of {} {}", &contender - contenders_.data() + 1, contenders_.size(),
                     contender.row.spec);
}

void CaseBench::fail(Contender& contender, const Outcome& outcome) const {
  contender.outcome = outcome;
  contender.cpu_total.clear();
}

void CaseBench::verify_one(Contender& contender) {
  if (stopped()) return;
  progress_.begin("verifying " + position(contender), scene_.t_end);
  auto result = verify(scene_, probes_, contender.method, reference_ ? &*reference_ : nullptr, options_.stop,
                       &progress_, options_.limits);
  progress_.end();
  if (result.outcome.status == Status::interrupted) return;
  contender.verified = true;
  contender.outcome = result.outcome;
  if (result.errors.empty()) return;
  const auto curves =
      probe_curves(scene_, probes_, contender.row.spec, result.history, reference_ ? &*reference_ : nullptr);
  observations_.curves.insert(observations_.curves.end(), curves.begin(), curves.end());
  contender.samples = sampled_.samples(result.history);
  const auto fields = scene_.rhs->fields();
  contender.row.errors = result.errors[main_field(*scene_.rhs)];
  for (std::size_t f = 0; fields.size() > 1 && f < fields.size(); ++f)
    if (fields[f].name == "potential") contender.row.potential = result.errors[f];
}

// The warm-up is an ordinary run: nothing is tracked, so its counts and its memory are those of the timed
// runs.
void CaseBench::warm_up(Contender& contender) {
  const Status known = contender.outcome.status;
  if (stopped() || !contender.verified || known == Status::refused || known == Status::timeout) return;
  progress_.begin("warming up " + position(contender), scene_.t_end);
  reset_peak_memory();
  RunRequest request{
      .spans = spans(), .stop = options_.stop, .progress = &progress_, .limits = options_.limits};
  std::optional<SliceRecorder> slice;
  if (scene_.packed && !observations_.slice) {  // there is no reference to take a picture of
    slice.emplace(scene_);
    request.observe = [&](std::size_t k, double t, auto state) { slice->observe(k, t, state); };
  }
  const RunResult run = run_one(scene_, contender.method, request);
  progress_.end();
  if (run.outcome.status == Status::interrupted) return;
  if (slice && run.outcome.ok()) observations_.slice = slice->take(contender.row.spec);
  BenchRow& row = contender.row;
  row.steps = run.statistics.steps;
  row.rejected = run.statistics.rejected;
  row.rhs = run.sweeps;
  row.jacobians = run.jacobians;
  row.factorizations = run.statistics.factorizations;
  row.solves = run.statistics.solves;
  row.max_stages = static_cast<std::uint64_t>(run.statistics.max_stages);
  row.error_bound = error_bound_of(run);
  row.rounding_bound = rounding_bound_of(run);
  row.choice = run.choice;
  row.processes = run.processes;
  row.peak_memory_mb = peak_memory_megabytes();
  contender.time_per_sweep = run.statistics.time_per_sweep;
  if (contender.outcome.ok() && !run.outcome.ok()) fail(contender, run.outcome);
}

void CaseBench::count(Contender& contender, BenchCase& out) {
  if (stopped() || !contender.verified || !is_timed(contender.outcome)) return;
  progress_.begin_timed("counting instructions of " + position(contender));
  const auto counted = count_instructions(program_file(), scene_.file, contender.row.spec, options_.stop);
  progress_.end();
  contender.row.instructions = counted.instructions;
  if (!counted.instructions && !stopped())
    out.warnings.push_back(
        fmt::format("{}: no instructions are counted: {}", contender.row.spec, counted.reason));
}

void CaseBench::time_round(std::size_t round) {
  for (const std::size_t k : round_order(contenders_.size(), round)) {
    Contender& contender = contenders_[k];
    if (stopped() || !contender.verified || !is_timed(contender.outcome)) continue;
    const double done = static_cast<double>(timed_runs_++), elapsed = wall_seconds() - timing_began_;
    const double all = static_cast<double>(options_.repetitions) * static_cast<double>(contenders_.size());
    progress_.begin_timed(fmt::format("round {} of {}: {}: {}", round + 1, options_.repetitions,
                                      position(contender), progress_text(done, all, elapsed, elapsed)));
    time_one(contender);
    progress_.end();
  }
  if (stopped()) return;
  if (const auto cost = joule_cost_.sample()) cpu_joule_.push_back(*cost);
}

void CaseBench::time_one(Contender& contender) {
  // Before and after, and the longer the longer the run: both then see the same state of the machine.
  constexpr double share = 0.04;
  const double length = contender.cpu_stepping.empty() ? 0 : share * contender.cpu_stepping.back();
  const double before = yardstick_.seconds(length);
  const RunResult run =
      run_one(scene_, contender.method,
              {.spans = spans(),
               .stop = options_.stop,
               .limits = {.seconds = options_.limits.seconds, .sweeps = options_.limits.sweeps, .say = {}}});
  if (run.outcome.status == Status::interrupted) return;
  if (!run.outcome.ok()) return fail(contender, run.outcome);
  contender.cpu_total.push_back(cpu_setup_ + run.cpu_prepare + run.cpu_stepping);
  contender.cpu_prepare.push_back(run.cpu_prepare);
  contender.cpu_stepping.push_back(run.cpu_stepping);
  contender.wall_stepping.push_back(run.wall_stepping);
  contender.yardstick.push_back(0.5 * (before + yardstick_.seconds(length)));
}

void CaseBench::compare_with_theory() {
  const auto baseline = std::find_if(contenders_.begin(), contenders_.end(), [&](const Contender& contender) {
    return contender.row.spec == scene_.bench.baseline;
  });
  if (baseline == contenders_.end() || !baseline->row.cpu_total) return;
  for (auto& contender : contenders_)
    if (contender.row.cpu_total)
      contender.row.speedup_theory = quotient(contender.time_per_sweep, baseline->time_per_sweep);
}

// The baseline may have been verified after others: samples are compared when all are there.
void CaseBench::compare_as_published() {
  if (!options_.sampled) return;
  const bool as_written = options_.sampled->as_written;
  std::vector<double> subtracted;
  if (!as_written && reference_) subtracted = sampled_.samples(reference_->history);
  for (const auto& contender : contenders_)
    if (as_written && contender.row.spec == scene_.bench.baseline) subtracted = contender.samples;
  const bool main = scene_.rhs->fields()[main_field(*scene_.rhs)].name == options_.sampled->field;
  for (auto& contender : contenders_) {
    if (as_written && contender.row.spec == scene_.bench.baseline) continue;  // nothing but zeros
    BenchRow& row = contender.row;
    if (FieldErrors* errors = main ? &row.errors : row.potential ? &*row.potential : nullptr)
      sampled_.measure(contender.samples, subtracted, *errors);
  }
}

void CaseBench::finish(BenchCase& out) {
  for (auto& contender : contenders_) {
    BenchRow& row = contender.row;
    row.status = status_name(contender.outcome.status);
    row.reason = contender.outcome.reason;
    row.repetitions = static_cast<int>(contender.cpu_total.size());
    if (reference_) row.reference = reference_->spec;
    if (reference_ && reference_->cpu_pilot > 0) row.cpu_pilot = reference_->cpu_pilot;
    if (contender.cpu_total.empty()) continue;
    row.cpu_prepare = summarize(contender.cpu_prepare).median;
    row.cpu_total = summarize(contender.cpu_total);
    row.cpu_stepping = summarize(contender.cpu_stepping);
    row.wall_stepping = summarize(contender.wall_stepping);
    row.cpu_stepping_samples = contender.cpu_stepping;
    row.yardstick_samples = contender.yardstick;
  }
  compare_with_theory();
  compare_as_published();
  if (!cpu_joule_.empty()) out.cpu_joule = summarize(cpu_joule_).median;
  for (auto& contender : contenders_)
    if (contender.verified) out.rows.push_back(std::move(contender.row));
  compare_with_baseline(out);
  warn_of_untold_tolerances(out);
}

}  // namespace

BenchCase bench_case(const Scene& scene, double cpu_setup, const HarnessOptions& options,
                     Progress& progress) {
  return CaseBench(scene, cpu_setup, options, progress).run();
}

}  // namespace superstep
