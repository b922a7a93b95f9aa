#include "bench/press/motion_schemes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "core/text/append.hpp"
#include "integrators/press/motion.hpp"
#include "results/text/csv_text.hpp"

namespace superstep {
namespace {

using dynamics::Motion;
using dynamics::State;
using dynamics::SteppingSettings;

double rms_distance(const State& a, const State& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 between = a.position[i] - b.position[i];
    sum += dot(between, between);
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

double rms_temperature(const State& a, const State& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = a.temperature[i] - b.temperature[i];
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

struct Finished {
  Outcome outcome;
  State state;
  MotionRow row;
};

Finished run(const Press& one, const SteppingSettings& stepping, const State& begin, double t_end) {
  Motion motion(one.model, one.particles, stepping);
  const double cpu = process_cpu_seconds();
  motion.start(begin);
  Finished finished;
  finished.outcome = motion.advance(t_end);
  finished.row.cpu = process_cpu_seconds() - cpu;
  finished.row.status = status_name(finished.outcome.status);
  finished.row.reason = finished.outcome.reason;
  finished.row.steps = motion.history().size() - 1;
  finished.row.rejected = motion.rejected();
  finished.row.force_evaluations = motion.iterations() + finished.row.steps;
  finished.state = motion.state();
  return finished;
}

SteppingSettings staggered(const Press& one, double tolerance, double largest_step) {
  SteppingSettings settings = one.stepping;
  settings.scheme = SteppingSettings::Scheme::staggered;
  settings.tolerance_position = settings.tolerance_temperature = tolerance;
  settings.largest_step = settings.first_step = largest_step;
  // The case says when its own steps have failed; these are shorter.
  constexpr double far_below = 1e-3;
  settings.smallest_step = std::min(settings.smallest_step, far_below * largest_step);
  return settings;
}

/// Far below the steps that the schemes take, so that the error of order 2 is far below theirs.
SteppingSettings reference_settings(const Press& one, double window, double steps) {
  SteppingSettings settings = staggered(one, 1e-10, window / steps);
  settings.phi = 0.5;
  settings.iterations = 50;
  settings.thermal_integrator.clear();
  return settings;
}

SteppingSettings plain(const Press& one, double fraction) {
  SteppingSettings settings = one.stepping;
  settings.scheme = SteppingSettings::Scheme::plain;
  settings.fraction = fraction;
  settings.smallest_step *= std::min(fraction, 1.0);
  return settings;
}

}  // namespace

MotionComparison compare_motion_schemes(const Press& one, Progress& progress) {
  const double begin = one.motion_window.value().first, end = one.motion_window->second;
  MotionComparison result{
      .begin = begin, .end = end, .travelled = 0, .reference = {}, .reference_error = 0, .rows = {}};
  progress.begin(one.name + ": motion", 1);
  Motion approach(one.model, one.particles, one.stepping);
  approach.start(one.state);
  const auto require_ok = [&](const Outcome& outcome, const char* what) {
    if (!outcome.ok()) throw NumericalError(fmt::format("{}: {}: {}", one.name, what, outcome.reason));
  };
  require_ok(approach.advance(begin), "the way to the motion window failed");
  const State start = approach.state();

  constexpr double reference_steps = 8000;
  const Finished coarse = run(one, reference_settings(one, end - begin, reference_steps / 2), start, end);
  const Finished exact = run(one, reference_settings(one, end - begin, reference_steps), start, end);
  require_ok(coarse.outcome, "the reference of the motion failed");
  require_ok(exact.outcome, "the reference of the motion failed");
  result.reference =
      fmt::format("staggered, tolerance 1e-10, step {:.3g} s", (end - begin) / reference_steps);
  result.reference_error = rms_distance(coarse.state, exact.state);
  result.travelled = rms_distance(start, exact.state);

  const auto add = [&](const char* scheme, std::string settings, const SteppingSettings& stepping) {
    Finished finished = run(one, stepping, start, end);
    MotionRow row = std::move(finished.row);
    row.scheme = scheme;
    row.settings = std::move(settings);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const bool is_there = finished.outcome.ok();
    row.error_position = is_there ? rms_distance(finished.state, exact.state) : none;
    row.error_temperature = is_there ? rms_temperature(finished.state, exact.state) : none;
    result.rows.push_back(std::move(row));
  };
  const double largest = one.stepping.largest_step;
  for (const double part : {1.0, 4.0, 16.0})
    for (const double tolerance : {5e-4, 1e-6})
      add("staggered", fmt::format("tolerance {:g}, step <= {:.3g} s", tolerance, largest / part),
          staggered(one, tolerance, largest / part));
  for (const double fraction : {0.95, 0.5, 0.2, 0.05, 0.01})
    add("plain", fmt::format("{:g} of its stability limit", fraction), plain(one, fraction));
  progress.end();
  return result;
}

std::string motion_table(const MotionComparison& comparison) {
  std::string text = fmt::format(
      "motion from {:g} to {:g} s: particles move by {:.3g} m (rms); reference {}, its error {:.1e} m\n",
      comparison.begin, comparison.end, comparison.travelled, comparison.reference,
      comparison.reference_error);
  text += fmt::format("{:<10} {:<36} {:<8} {:>8} {:>9} {:>10} {:>9} {:>10} {:>10}\n", "scheme", "settings",
                      "status", "steps", "restarts", "force eval", "CPU [s]", "error [m]", "error [K]");
  const auto shown = [](double error) { return std::isnan(error) ? "-" : fmt::format("{:.2e}", error); };
  for (const auto& row : comparison.rows)
    text += fmt::format("{:<10} {:<36} {:<8} {:>8} {:>9} {:>10} {:>9.3g} {:>10} {:>10}\n", row.scheme,
                        row.settings, row.status, row.steps, row.rejected, row.force_evaluations, row.cpu,
                        shown(row.error_position), shown(row.error_temperature));
  return text;
}

std::string motion_csv(const Press& one, const MotionComparison& comparison) {
  std::string out =
      "case,scheme,settings,status,reason,begin,end,steps,rejected,force_evaluations,cpu_stepping_s,"
      "error_position_rms,error_temperature_rms,reference_error_position\n";
  const auto cell = [](double error) { return std::isnan(error) ? std::string() : csv_cell(error); };
  for (const auto& row : comparison.rows)
    append(out, "{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_cell(one.name), row.scheme,
           csv_cell(row.settings), row.status, csv_cell(row.reason), comparison.begin, comparison.end,
           row.steps, row.rejected, row.force_evaluations, row.cpu, cell(row.error_position),
           cell(row.error_temperature), comparison.reference_error);
  return out;
}

}  // namespace superstep
