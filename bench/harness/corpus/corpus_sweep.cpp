#include "bench/harness/corpus/corpus_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "bench/harness/harness.hpp"
#include "bench/harness/reference.hpp"
#include "bench/harness/verification.hpp"
#include "bench/host/machine.hpp"
#include "bench/measure/probe_set.hpp"
#include "bench/measure/run_one.hpp"
#include "bench/measure/scene_facts.hpp"
#include "core/hash.hpp"
#include "core/median.hpp"
#include "core/stopwatch.hpp"
#include "integrators/costs/work.hpp"
#include "integrators/registry.hpp"
#include "results/corpus/corpus_cells.hpp"
#include "results/study/work_precision.hpp"

namespace superstep {
namespace {

constexpr double long_run = 0.2;  // s; the first of longer ones is a sample: warming up is no part of them
constexpr double long_sample = 5e-3;     // s; shorter runs are repeated within a round, and the least counts
constexpr int most_in_a_sample = 5;      // runs
constexpr double hopeless = 2;           // times slower than another that errs no more: once is enough
constexpr double out_of_sight = 20;      // times slower than one that reaches every error: not run to its end
constexpr double least_patience = 0.05;  // s; shorter runs are let be
constexpr double cold_run = 0.02;        // s; shorter first runs are repeated at once
constexpr double seconds_between_keeps = 20;
constexpr double least_for_a_reference = 300;  // s

std::string fact(const std::vector<Fact>& facts, const std::string& name) {
  for (const auto& one : facts)
    if (one.name == name) return one.value;
  return {};
}

class SceneSweep {
 public:
  SceneSweep(const Scene& scene, const CorpusTags& tags, const CorpusOptions& options, const KeepRows& keep,
             Progress& progress)
      : scene_(scene), options_(options), keep_(keep), progress_(progress) {
    facts_.scene = scene.name;
    facts_.set = tags.set;
    facts_.scene_class = tags.scene_class;
    facts_.kind = tags.kind;
    facts_.unknowns = scene.rhs->size();
    facts_.contrast = tags.contrast;
    if (scene.rhs->size() > 0) facts_.stiffness = scene.t_end * scene.rhs->spectral_bound(0, scene.initial);
    const Work work = work_of(*scene.rhs, 0, scene.output_times);
    facts_.physics = std::string(physics_name(work.physics)) + (work.steady ? "-steady" : "");
    facts_.pieces = work.pieces;
    facts_.shapes = work.shapes;
    facts_.output_decades = work.output_decades;
    facts_.nonzeros = static_cast<std::uint64_t>(work.nonzeros);
    facts_.threads = static_cast<std::uint64_t>(options.threads);
    facts_.time_limit = options.limits.seconds;
    facts_.processor = fact(machine_facts(), "processor");
    facts_.revision = program_revision();
    facts_.key = corpus_key(scene, options.threads);
  }

  std::vector<CorpusRow> run(std::span<const CorpusRow> known) {
    for (const auto& spec : corpus_specs(options_.integrators)) enter(spec, known);
    if (!find_reference()) return std::move(rows_);
    for (const std::size_t k : fast_ones_first())
      if (!stopped()) first_run(k);
    for (int round = 0; round < options_.repetitions; ++round)
      for (const std::size_t k : round_order(rows_.size(), static_cast<std::size_t>(round)))
        if (!stopped() && contends(rows_[k])) sample(k);
    std::erase_if(rows_, [](const CorpusRow& row) { return row.status.empty(); });  // never started
    return std::move(rows_);
  }

 private:
  [[nodiscard]] bool stopped() const noexcept { return options_.stop && options_.stop->load(); }

  /// What `auto` takes is seldom far from the fastest, and knowing that early spares time on hopeless ones.
  [[nodiscard]] std::vector<std::size_t> fast_ones_first() const {
    std::vector<std::size_t> order(rows_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_partition(order.begin(), order.end(),
                          [&](std::size_t k) { return rows_[k].integrator == "auto"; });
    return order;
  }

  /// CPU time that a run may take [s], and why: one that is many times slower than another that reaches every
  /// error that is judged has no part in any answer.
  struct Patience {
    double seconds = 0;
    const CorpusRow* faster = nullptr;
  };
  [[nodiscard]] Patience patience() const {
    Patience out{options_.limits.seconds, nullptr};
    for (const auto& row : rows_) {
      if (!row.ok() || !row.cpu || !row.error) continue;
      const double least_error =
          std::max(corpus_levels().back(), bars_that_count * row.reference_error.value_or(0));
      const double seconds = std::max(least_patience, out_of_sight * *row.cpu);
      if (*row.error <= least_error && (!(out.seconds > 0) || seconds < out.seconds)) out = {seconds, &row};
    }
    return out;
  }

  void enter(const std::string& spec, std::span<const CorpusRow> known) {
    const Spec parsed = parse_spec(spec);
    CorpusRow row = facts_;
    row.spec = spec;
    row.integrator = parsed.name;
    row.params = parsed.parameters();
    const bool seen = std::any_of(known.begin(), known.end(), [&](const CorpusRow& one) {
      const bool same = one.key == facts_.key && one.spec == spec;
      const bool more_time = one.status == "timeout" && one.time_limit < facts_.time_limit;
      if (same && !more_time) row = one;
      return same && !more_time;
    });
    // A family is what a ladder steps through; methods of fixed steps cost the same in all their variants.
    group_.push_back(find_integrator(parsed.name).adaptive ? family_of(parsed) : parsed.name);
    seen_.push_back(seen);
    rows_.push_back(std::move(row));
  }

  bool find_reference() {
    const bool all_seen = std::all_of(seen_.begin(), seen_.end(), [](bool seen) { return seen; });
    const bool all_done = all_seen && std::none_of(rows_.begin(), rows_.end(), [&](const CorpusRow& row) {
                            return contends(row) && wanting(row);
                          });
    if (all_done) return false;
    const ProbeSet probes(scene_);
    RunLimits limits = limits_of_reference(options_.limits);
    limits.seconds = std::max(limits.seconds, least_for_a_reference);
    auto found = obtain_reference(scene_, probes, {"", options_.use_cache, options_.stop, limits}, progress_);
    if (!found.reference) {
      rows_.clear();
      if (found.outcome.status != Status::interrupted) rows_.push_back(no_reference(found.outcome));
      return false;
    }
    reference_ = std::move(*found.reference);
    double bar = 0, span = 0;
    for (std::size_t f = 0; f < reference_.spans.size(); ++f) {
      span = std::max(span, reference_.spans[f]);
      if (reference_.spans[f] > 0) bar = std::max(bar, reference_.error_bar[f] / reference_.spans[f]);
    }
    if (!(span > 0)) {
      rows_.clear();
      rows_.push_back(no_reference({Status::refused, "nothing moves: there is no error to measure against"}));
      return false;
    }
    for (auto& row : rows_) {
      row.reference = reference_.spec;
      row.reference_error = bar;
    }
    return true;
  }

  [[nodiscard]] CorpusRow no_reference(const Outcome& outcome) const {
    CorpusRow row = facts_;
    row.spec = row.integrator = "reference";
    row.status = status_name(outcome.status);
    row.reason = outcome.reason;
    return row;
  }

  RunResult run_row(const CorpusRow& row, OutputErrors* errors, double seconds) {
    RunRequest request{.spans = reference_.spans, .stop = options_.stop, .limits = options_.limits};
    request.limits.seconds = seconds;
    if (errors)
      request.observe = [&](std::size_t output, double t, std::span<const double> state) {
        errors->observe(output, t, state);
      };
    return run_one(scene_, row.spec, request);
  }

  /// The worst of the fields, over the span.
  static double worst(const OutputErrors& errors) {
    double worst = 0;
    for (const auto& one : errors.errors())
      if (one.rms && *one.span > 0) worst = std::max(worst, *one.rms / *one.span);
    return worst;
  }

  /// Its error, its memory, and whether it ends.
  void first_run(std::size_t k) {
    CorpusRow& row = rows_[k];
    if (seen_[k]) return;
    if (const auto late = late_.find(group_[k]); late != late_.end()) {
      row.status = status_name(Status::timeout);
      row.reason = fmt::format("not begun: {} was not done in time", late->second);
      return;
    }
    progress_.begin_timed(fmt::format("{} {} of {} {}", scene_.name, k + 1, rows_.size(), row.spec));
    reset_peak_memory();
    const double before = peak_memory_megabytes();
    OutputErrors errors(scene_, &reference_);
    const Patience patience = this->patience();
    const RunResult run = run_row(row, &errors, patience.seconds);
    progress_.end();
    if (run.outcome.status == Status::interrupted) return;
    row.memory = std::max(0.0, peak_memory_megabytes() - before);
    Outcome outcome = run.outcome;
    if (outcome.ok()) errors.judge_besides(main_field(*scene_.rhs), outcome);
    row.status = status_name(outcome.status);
    row.reason = outcome.reason;
    row.sweeps = run.sweeps;
    row.steps = run.statistics.steps;
    row.choice = run.choice;
    if (run.outcome.status == Status::timeout) late_.emplace(group_[k], row.spec);
    if (run.outcome.status == Status::timeout && patience.faster)
      row.reason =
          fmt::format("not done after {:.2g} s of CPU time; {} reaches {:.1e} in {:.2g} s", patience.seconds,
                      patience.faster->spec, *patience.faster->error, *patience.faster->cpu);
    if (run.outcome.ok()) {
      row.error = worst(errors);
      row.samples = {run.cpu_prepare + run.cpu_stepping};
      row.cpu_prepare = run.cpu_prepare;
      if (row.samples.front() < cold_run) warm_up(row);
      row.cpu = row.samples.front();
      warming_.push_back(k);
    }
    keep_now_and_then();
  }

  /// A short first run is mostly about memory that was not there yet: again.
  void warm_up(CorpusRow& row) {
    const RunResult run = run_row(row, nullptr, options_.limits.seconds);
    const double seconds = run.cpu_prepare + run.cpu_stepping;
    if (!run.outcome.ok() || seconds > row.samples.front()) return;
    row.samples.front() = seconds;
    row.cpu_prepare = run.cpu_prepare;
  }

  /// Rounds that a row still lacks.
  [[nodiscard]] bool wanting(const CorpusRow& row) const {
    return row.samples.size() < static_cast<std::size_t>(options_.repetitions);
  }

  /// True unless another row that errs no more is much faster. What `auto` does is always of interest.
  [[nodiscard]] bool contends(const CorpusRow& row) const {
    if (!row.ok() || !row.cpu || !row.error) return false;
    if (row.integrator == "auto") return true;
    const double floor = bars_that_count * row.reference_error.value_or(0),
                 error = std::max(*row.error, floor);
    return std::none_of(rows_.begin(), rows_.end(), [&](const CorpusRow& other) {
      return other.ok() && other.cpu && other.error && std::max(*other.error, floor) <= error &&
             *other.cpu * hopeless < *row.cpu;
    });
  }

  void sample(std::size_t k) {
    CorpusRow& row = rows_[k];
    const bool warm = std::erase(warming_, k) > 0;
    if (warm && *row.cpu < long_run) row.samples.clear();
    if (!wanting(row)) return;
    progress_.begin_timed(fmt::format("{} again {}", scene_.name, row.spec));
    double least = 0, spent = 0;
    for (int n = 0; n < most_in_a_sample && (n == 0 || spent < long_sample); ++n) {
      const RunResult run = run_row(row, nullptr, options_.limits.seconds);
      if (run.outcome.status == Status::interrupted) break;
      if (!run.outcome.ok()) {  // it ended once, so that this says something about the machine, too
        row.status = status_name(run.outcome.status);
        row.reason = run.outcome.reason;
        break;
      }
      const double seconds = run.cpu_prepare + run.cpu_stepping;
      spent += seconds;
      if (n == 0 || seconds < least) {
        least = seconds;
        row.cpu_prepare = run.cpu_prepare;
      }
    }
    progress_.end();
    if (spent > 0) row.samples.push_back(least);
    if (!row.samples.empty()) row.cpu = median_of(row.samples);
    keep_now_and_then();
  }

  void keep_now_and_then() {
    if (wall_seconds() - kept_ < seconds_between_keeps) return;
    kept_ = wall_seconds();
    std::vector<CorpusRow> begun;
    for (const auto& row : rows_)
      if (!row.status.empty()) begun.push_back(row);
    keep_(begun);
  }

  const Scene& scene_;
  const CorpusOptions& options_;
  const KeepRows& keep_;
  Progress& progress_;
  CorpusRow facts_;  // what all rows share
  Reference reference_;
  std::vector<CorpusRow> rows_;
  std::vector<std::string> group_;           // [rows]
  std::vector<bool> seen_;                   // [rows] taken over
  std::vector<std::size_t> warming_;         // rows whose only sample is their first run
  std::map<std::string, std::string> late_;  // groups that ran out of time, and the SPEC that did
  double kept_ = wall_seconds();
};

}  // namespace

std::vector<std::string> corpus_specs(const std::vector<std::string>& asked) {
  std::vector<std::string> specs;
  const auto take = [&](const std::string& spec) {
    specs.push_back(spec);
    if (!repeated_spec(specs).empty()) specs.pop_back();  // a step of a ladder that was given by itself, too
  };
  for (const auto& one : asked) {
    const Spec parsed = parse_spec(one);
    const auto& ladder = find_integrator(parsed.name).ladder;
    if (parsed.settings.empty() && !ladder.empty())
      for (const auto& spec : ladder) take(spec);
    else
      take(one);
  }
  if (asked.empty())
    for (const auto& entry : integrators())
      for (const auto& spec : entry.ladder) take(spec);
  return specs;
}

std::string corpus_key(const Scene& scene, int threads) {
  ContentHash hash;
  hash.add(scene.content_hash).add(program_version()).add(program_revision());
  for (const auto& one : machine_facts()) hash.add(one.name).add(one.value);
  for (const auto& one : library_facts()) hash.add(one.name).add(one.value);
  hash.add_number(threads);
  return hash.text();
}

std::vector<CorpusRow> sweep_scene(const Scene& scene, const CorpusTags& tags, const CorpusOptions& options,
                                   std::span<const CorpusRow> known, const KeepRows& keep,
                                   Progress& progress) {
  return SceneSweep(scene, tags, options, keep, progress).run(known);
}

}  // namespace superstep
