#pragma once
/// A benchmark as a harness could have measured it, with names that mean harm.

#include <cmath>
#include <string>

#include "results/results.hpp"
#include "results/study/work_precision.hpp"

namespace superstep::test {

inline const std::string hostile_name =
    "</script><script>window.hacked=1</script>\"quoted\" 'single' =cmd() ünïcode ∑ {{body}} " +
    std::string(200, 'w');

inline BenchRow sample_row(const std::string& case_name, const std::string& integrator,
                           const std::string& params, double cpu) {
  BenchRow row;
  row.case_name = case_name;
  row.integrator = integrator;
  row.params = params;
  row.spec = integrator + (params.empty() ? "" : ":" + params);
  row.status = "ok";
  row.nodes = 12;
  row.contacts = 20;
  row.t_end = 1e-3;
  row.repetitions = 3;
  row.cpu_total = Timing{cpu + 0.1, cpu + 0.09, cpu + 0.2};
  row.cpu_stepping = Timing{cpu, 0.9 * cpu, 1.2 * cpu};
  row.wall_stepping = row.cpu_stepping;
  row.speedup_total = 2 / cpu;
  row.speedup_stepping = 2 / cpu;
  row.speedup_theory = 2.5 / cpu;
  row.steps = 100;
  row.rejected = 0;
  row.rhs = 1000;
  row.jacobians = row.factorizations = row.solves = 0;
  row.max_stages = 10;
  row.peak_memory_mb = 12.5;
  row.errors = {.probe_mean = 1e-3,
                .rms = 1e-3,
                .max = 5e-3,
                .relative_rms = 1e-4,
                .overshoot = 0.0,
                .balance = 1e-12,
                .decay_rate = 900.0,
                .decay_r2 = 0.9,
                .reference_error = 1e-9,
                .published_mean = 2e-3,
                .published_rate = 850.0,
                .published_r2 = 0.8,
                .span = 10.0,
                .delivered = 0.4,
                .distance_to_cvode = 2e-4};
  row.reference = "cvode:rtol=1e-9";
  return row;
}

inline ProbeCurve sample_curve(const std::string& spec) {
  ProbeCurve curve{.spec = spec, .field = "temperature", .unit = "K", .probe = "mid-height"};
  for (int k = 0; k <= 50; ++k) {
    const double t = 1e-3 * k / 50;
    curve.time.push_back(t);
    curve.reference.push_back(5 - 5 * std::exp(-5000 * t));
    curve.value.push_back(curve.reference.back() + 0.01 * std::exp(-900 * t) * (k > 0 ? 1 : 0));
  }
  curve.transient = 40;
  return curve;
}

inline Slice sample_slice(std::size_t spheres) {
  Slice slice{.source = "cvode:rtol=1e-9", .cut = spheres + 3};
  for (const double t : {0.0, 1e-4, 1e-3})
    slice.frames.push_back({.field = "temperature", .unit = "K", .time = t});
  for (std::size_t k = 0; k < spheres; ++k) {
    const auto column = static_cast<double>(k % 60), row = static_cast<double>(k / 60);
    slice.spheres.push_back({static_cast<std::int64_t>(k), column, row, 0.5, 0.5});
    for (auto& frame : slice.frames) frame.value.push_back(row * (1 + frame.time));
  }
  return slice;
}

/// One good case with a hostile name, a failed run and super-time-stepping.
inline BenchReport sample_report() {
  BenchCase one;
  one.name = hostile_name;
  one.title = hostile_name;
  one.source = "Rojek & Nisar 2026, section 9.1";
  one.baseline = "forward-euler";
  one.nodes = 12;
  one.contacts = 20;
  one.unknowns = 10;
  one.t_end = 1e-3;
  one.cpu_setup = 0.1;
  one.output_times = {1e-4, 1e-3};
  one.unit = "K";
  one.reference = ReferenceFacts{"cvode:rtol=1e-9", false, 1.5};
  one.sampled =
      SampledMeasure{.field = "temperature", .every = 1e-5, .from = 2e-5, .to = 1e-3, .as_written = true};
  one.cpu_joule = 1.5e-5;
  one.rows = {sample_row(one.name, "forward-euler", "", 2), sample_row(one.name, "sts", "n=10,nu=1e-3", 0.3),
              sample_row(one.name, "sts", "n=20,nu=1e-4", 0.2), sample_row(one.name, hostile_name, "", 1)};
  BenchRow failed;
  failed.case_name = one.name;
  failed.integrator = failed.spec = "rkc";
  failed.status = "unstable";
  failed.reason = hostile_name;
  failed.t_end = 1e-3;
  one.rows.push_back(failed);
  one.warnings = {hostile_name};
  one.skips = {{hostile_name, hostile_name}};
  for (const auto& row : one.rows)
    if (row.ok()) one.observations.curves.push_back(sample_curve(row.spec));
  one.observations.slice = sample_slice(100);
  BenchReport report;
  report.version = "1.2.3";
  report.revision = "abc";
  report.machine = {{"processor", hostile_name}};
  report.libraries = {{"fmt", "9"}};
  report.repetitions = 3;
  report.threads = 1;
  report.cases = {one};
  return report;
}

inline RunRecord sample_run() {
  RunRecord run;
  run.version = "1.2.3";
  run.case_name = "rod";
  run.title = hostile_name;
  run.integrator = "rkc";
  run.params = "rtol=1e-4";
  run.choice = "s = 5";
  run.status = "ok";
  run.t_end = run.t_reached = 1e-3;
  run.nodes = 12;
  run.steps = 5;
  run.rhs = 25;
  run.max_stages = 5;
  run.cpu_stepping = 0.25;
  run.files = {"run.json"};
  run.warnings = {hostile_name};
  run.skips = {{"a", "b"}};
  run.machine = {{"processor", "x"}};
  return run;
}

inline WorkPrecision sample_study() {
  WorkPrecision study;
  study.case_name = hostile_name;
  study.reference = "exponential:rtol=1e-15";
  study.reference_error = 1e-12;
  study.span = 10;
  study.unknowns = 10;
  study.repetitions = 1;
  study.output_times = {1e-4, 1e-3};
  for (const double error : {1e-2, 1e-4}) {
    const std::string params = error > 1e-3 ? "order=1,rtol=1e-2" : "order=1,rtol=1e-4";
    WorkPrecisionPoint point{.family = "rkc order=1",
                             .spec = "rkc:" + params,
                             .integrator = "rkc",
                             .params = params,
                             .status = "ok",
                             .reason = ""};
    point.sweeps = 100;
    point.steps = 10;
    point.cpu = Timing{0.01 / error, 0.01 / error, 0.01 / error};
    point.error_rms = {error, error / 2};
    point.worst = error;
    point.worst_relative = error / study.span;
    study.points.push_back(point);
  }
  study.points.push_back({.family = "sts",
                          .spec = "sts:n=5",
                          .integrator = "sts",
                          .params = "n=5",
                          .status = "unstable",
                          .reason = hostile_name});
  return study;
}

}  // namespace superstep::test
