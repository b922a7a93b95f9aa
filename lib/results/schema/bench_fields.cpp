#include "results/schema/bench_fields.hpp"

#include <algorithm>
#include <span>

#include "core/error.hpp"
#include "core/text/options.hpp"

namespace superstep {
namespace {

using Errors = RecordField<FieldErrors>;

// Groups in the order in which they came into being: what came later stands at the end.

RecordFields<FieldErrors> first_errors() {
  return {
      amount("error_probe_mean", &FieldErrors::probe_mean,
             "K or V; mean difference to the reference at the first probe, over the step ends of "
             "the transient"),
      amount("error_rms", &FieldErrors::rms, "K or V; over free nodes, worst output time"),
      amount("error_max", &FieldErrors::max, "K or V; over free nodes, worst output time"),
      amount("error_relative_rms", &FieldErrors::relative_rms, "error_rms over the span of the field"),
      amount("overshoot", &FieldErrors::overshoot,
             "K or V; how far a value leaves the range that the maximum principle allows"),
      field("balance", &FieldErrors::balance, "(heat entered - heat stored) / heat entered"),
      field("decay_rate", &FieldErrors::decay_rate,
            "1/s; k of the fit Z exp(-k t) to the error at the probe"),
      field("decay_r2", &FieldErrors::decay_r2, "R2 of that fit"),
  };
}

Errors reference_error() {
  return amount("reference_error", &FieldErrors::reference_error,
                "K or V; error bar of the reference, rms; errors below it are its own");
}

RecordFields<FieldErrors> later_errors() {
  return {
      amount("error_as_published", &FieldErrors::published_mean,
             "K or V; mean difference at the first probe by the rule of the published table"),
      field("decay_rate_as_published", &FieldErrors::published_rate,
            "1/s; k = -slope ln 10 of the fit to those differences, over the whole window"),
      field("decay_r2_as_published", &FieldErrors::published_r2, "R2 of that fit"),
      amount("span", &FieldErrors::span,
             "K or V; largest minus smallest value of the field over all nodes and the whole run"),
      amount("delivered", &FieldErrors::delivered,
             "error_rms over what was asked for, rtol times the span; empty for fixed steps, and where the "
             "reference cannot tell"),
      amount("distance_to_cvode", &FieldErrors::distance_to_cvode,
             "rms distance to CVODE over the span, worst over the output times"),
  };
}

RecordField<BenchRow> of_main_field(const Errors& one) {
  return {one.name, one.meaning, one.schema,
          [write = one.write](const BenchRow& row) { return write(row.errors); },
          [read = one.read](BenchRow& row, const JsonObject& json) { read(row.errors, json); }};
}

/// What a row of one field leaves out.
RecordField<BenchRow> of_potential(const Errors& one) {
  const std::string name = one.name + "_potential";
  return {name,
          one.meaning + ", of the potential",
          one.schema,
          [write = one.write](const BenchRow& row) { return row.potential ? write(*row.potential) : Json(); },
          [one, name](BenchRow& row, const JsonObject& json) {
            const Json* value = json.find(name);
            if (!value) return;
            const Json renamed = {{one.name, *value}};
            if (!row.potential) row.potential.emplace();
            (void)json.number(name);  // names the key where it is not a number
            if (one.schema.contains("minimum")) json.require_not_negative(name);
            one.read(*row.potential, JsonObject({}, renamed));
          },
          /*always=*/false};
}

std::vector<RecordField<BenchRow>> work_columns() {
  const auto median = [](std::optional<Timing> BenchRow::*timing) {
    return [timing](const BenchRow& row) { return row.*timing ? Number((row.*timing)->median) : Number(); };
  };
  auto params = field("params", &BenchRow::params, "SPEC behind the colon");
  params.read = [](BenchRow& row, const JsonObject& json) {
    row.params = json.text("params");
    row.spec = row.integrator + (row.params.empty() ? "" : ":" + row.params);
    try {
      (void)parse_spec(row.spec);
    } catch (const UsageError& error) {  // nobody typed it: it is the file that has to be mended
      json.reject(row.params.empty() ? "integrator" : "params", error.what());
    }
  };
  return {
      field("case", &BenchRow::case_name, "stem of the case file"),
      field("integrator", &BenchRow::integrator, "SPEC before the colon"),
      params,
      one_of(field("status", &BenchRow::status,
                   "ok, inaccurate, unstable, failed, refused, timeout or interrupted"),
             statuses()),
      field("reason", &BenchRow::reason, "why it is not ok, and what helps"),
      field("nodes", &BenchRow::nodes, "of the network, fixed nodes included"),
      field("contacts", &BenchRow::contacts, "of the network"),
      amount("t_end", &BenchRow::t_end, "s; simulated time"),
      field("repetitions", &BenchRow::repetitions, "timed runs"),
      field("threads", &BenchRow::threads, "threads that were allowed"),
      derived<BenchRow>("cpu_total_s", median(&BenchRow::cpu_total),
                        "s; process CPU time of reading, preparing and stepping, median"),
      derived<BenchRow>("cpu_stepping_s", median(&BenchRow::cpu_stepping),
                        "s; process CPU time of the integration alone, median"),
      derived<BenchRow>("wall_stepping_s", median(&BenchRow::wall_stepping),
                        "s; wall time of the integration alone, median"),
      amount("speedup_total", &BenchRow::speedup_total, "CPU time of the baseline over that of the row"),
      amount("speedup_stepping", &BenchRow::speedup_stepping, "the same, of the integration alone"),
      amount("speedup_theory", &BenchRow::speedup_theory,
             "simulated time per sweep over that of the baseline, for methods with a fixed step"),
      field("steps", &BenchRow::steps, "accepted steps (supersteps for STS)"),
      field("rejected", &BenchRow::rejected, "rejected steps"),
      field("rhs", &BenchRow::rhs, "sweeps over the network, fused or not, preparation included"),
      field("jacobians", &BenchRow::jacobians, "evaluations of the Jacobian"),
      field("factorizations", &BenchRow::factorizations, "factorizations"),
      field("solves", &BenchRow::solves, "linear solves"),
      field("max_stages", &BenchRow::max_stages, "most sweeps in one step"),
      amount("peak_memory_mb", &BenchRow::peak_memory_mb, "1e6 bytes; largest resident set while it ran"),
  };
}

}  // namespace

const std::vector<std::string>& statuses() {
  static const std::vector<std::string> all = {"ok",      "inaccurate", "unstable",   "failed",
                                               "refused", "timeout",    "interrupted"};
  return all;
}

bool any_potential(std::span<const BenchCase> cases) {
  return std::any_of(cases.begin(), cases.end(), [](const BenchCase& one) {
    return std::any_of(one.rows.begin(), one.rows.end(),
                       [](const BenchRow& row) { return row.potential.has_value(); });
  });
}

RecordFields<BenchRow> bench_columns(bool potential) {
  auto columns = work_columns();
  for (const auto& one : first_errors()) columns.push_back(of_main_field(one));
  columns.push_back(field("reference", &BenchRow::reference, "SPEC that errors are measured against"));
  columns.push_back(of_main_field(reference_error()));
  if (potential) {
    for (const auto& one : first_errors()) columns.push_back(of_potential(one));
    columns.push_back(of_potential(reference_error()));
  }
  for (const auto& one : later_errors()) columns.push_back(of_main_field(one));
  if (potential)
    for (const auto& one : later_errors()) columns.push_back(of_potential(one));
  columns.push_back(amount("cpu_prepare_s", &BenchRow::cpu_prepare,
                           "s; before the first step: spectrum, factorization, choice; median"));
  columns.push_back(amount("speedup_prepared", &BenchRow::speedup_prepared,
                           "preparation and stepping together, against the baseline"));
  columns.push_back(amount("cpu_pilot_s", &BenchRow::cpu_pilot,
                           "s; of the run that found the spans; empty where none was needed"));
  columns.push_back(amount(
      "error_bound", &BenchRow::error_bound,
      "bound of the error over the span, rms: proven but for roundings; empty where a method has none"));
  columns.push_back(amount("cpu_verify_s", &BenchRow::cpu_verify,
                           "s; of the runs by which a method checked itself; empty where it did not"));
  columns.push_back(field("processes", &BenchRow::processes, "processes that took part"));
  columns.push_back(field("instructions", &BenchRow::instructions,
                          "executed between start and end of the integration, counted by callgrind; empty "
                          "without --instructions"));
  columns.push_back(amount("rounding_bound", &BenchRow::rounding_bound,
                           "the part of error_bound that is rounding, by a model"));
  return columns;
}

template <>
const RecordFields<FieldErrors>& fields_of<FieldErrors>() {
  static const RecordFields<FieldErrors> fields = [] {
    auto all = first_errors();
    all.push_back(reference_error());
    for (auto& one : later_errors()) all.push_back(std::move(one));
    return all;
  }();
  return fields;
}

template <>
const RecordFields<SampledMeasure>& fields_of<SampledMeasure>() {
  static const RecordFields<SampledMeasure> fields{
      field("field", &SampledMeasure::field, "temperature or potential"),
      field("every", &SampledMeasure::every, "s; instants from, from + every, ..., to"),
      field("from", &SampledMeasure::from, "s"),
      field("to", &SampledMeasure::to, "s"),
      field(
          "as_written", &SampledMeasure::as_written,
          "true: both codes write the state of their first step end at or after each instant and the "
          "baseline's is subtracted as if both were of one moment; false: the error against the reference at "
          "the instant"),
  };
  return fields;
}

template <>
const RecordFields<Timing>& fields_of<Timing>() {
  static const RecordFields<Timing> fields{amount("median", &Timing::median), amount("min", &Timing::min),
                                           amount("max", &Timing::max)};
  return fields;
}

template <>
const RecordFields<ReferenceFacts>& fields_of<ReferenceFacts>() {
  static const RecordFields<ReferenceFacts> fields{
      field("spec", &ReferenceFacts::spec), field("from_cache", &ReferenceFacts::from_cache),
      amount("cpu_s", &ReferenceFacts::cpu_seconds, "s; 0 from the cache")};
  return fields;
}

template <>
const RecordFields<SkippedWork>& fields_of<SkippedWork>() {
  static const RecordFields<SkippedWork> fields{field("what", &SkippedWork::what),
                                                field("because", &SkippedWork::because)};
  return fields;
}

template <>
const RecordFields<BenchRow>& fields_of<BenchRow>() {
  static const RecordFields<BenchRow> fields = [] {
    auto all = bench_columns(/*potential=*/true);
    auto spec = field("spec", &BenchRow::spec, "integrator and params as the user wrote them");
    spec.read = {};  // follows from the two
    all.push_back(spec);
    all.push_back(field("choice", &BenchRow::choice, "what the method chose by itself and why"));
    all.push_back(group<BenchRow>(
        "spread",
        {field("cpu_total_s", &BenchRow::cpu_total), field("cpu_stepping_s", &BenchRow::cpu_stepping),
         field("wall_stepping_s", &BenchRow::wall_stepping)},
        "s; of the repetitions"));
    all.push_back(
        amount("cpu_stepping_samples_s", &BenchRow::cpu_stepping_samples, "s; in the order of the rounds"));
    all.push_back(
        amount("yardstick_samples_s", &BenchRow::yardstick_samples, "s; a fixed piece of work around each"));
    return all;
  }();
  return fields;
}

template <>
const RecordFields<BenchCase>& fields_of<BenchCase>() {
  static const RecordFields<BenchCase> fields{
      field("case", &BenchCase::name, "stem of the case file"),
      field("title", &BenchCase::title),
      field("source", &BenchCase::source),
      field("nodes", &BenchCase::nodes),
      field("contacts", &BenchCase::contacts),
      field("unknowns", &BenchCase::unknowns, "entries of the state"),
      amount("t_end", &BenchCase::t_end, "s"),
      amount("output_times", &BenchCase::output_times, "s"),
      field("error_unit", &BenchCase::unit, "K or V, of the main error columns"),
      field("baseline", &BenchCase::baseline, "SPEC that speedups refer to"),
      amount("cpu_setup_s", &BenchCase::cpu_setup,
             "s; CPU time of reading and building the scene, part of every cpu_total_s"),
      field("reference", &BenchCase::reference),
      derived<BenchCase>("reference_from_cache",
                         [](const BenchCase& one) { return one.reference && one.reference->from_cache; }),
      field("errors_as_published", &BenchCase::sampled, "rule of the published table"),
      field("cpu_joule_s", &BenchCase::cpu_joule,
            "s; CPU time by which a substep of both fields is dearer for evaluating the Joule heat"),
      field("skips", &BenchCase::skips, "work that the scene does not need"),
      field("warnings", &BenchCase::warnings),
      field("rows", &BenchCase::rows, "one a method"),
  };
  return fields;
}

template <>
const RecordFields<BenchReport>& fields_of<BenchReport>() {
  static const RecordFields<BenchReport> fields{
      field("version", &BenchReport::version, "of the program"),
      field("revision", &BenchReport::revision, "of the program"),
      field("machine", &BenchReport::machine, "facts by name"),
      field("libraries", &BenchReport::libraries, "facts by name"),
      field("repetitions", &BenchReport::repetitions),
      field("threads", &BenchReport::threads),
      field("interrupted", &BenchReport::interrupted, "by Ctrl-C"),
      field("cases", &BenchReport::cases),
  };
  return fields;
}

}  // namespace superstep
