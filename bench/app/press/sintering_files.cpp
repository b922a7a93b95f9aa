#include "bench/app/press/sintering_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "bench/host/machine.hpp"
#include "core/stopwatch.hpp"
#include "core/text/append.hpp"
#include "core/text/options.hpp"
#include "core/text/quantity.hpp"
#include "results/results_json.hpp"
#include "results/text/csv_text.hpp"

namespace superstep {
namespace {

using dynamics::HistoryRow;
using dynamics::Motion;

const std::string& phase_name(const Press& one, const HistoryRow& row) {
  return one.model.schedule.phases()[static_cast<std::size_t>(row.phase)].name;
}

/// Last row of each phase that the run came into.
std::vector<HistoryRow> phase_ends(std::span<const HistoryRow> history) {
  std::vector<HistoryRow> ends;
  for (std::size_t k = 0; k < history.size(); ++k)
    if (k + 1 == history.size() || (k > 0 && history[k + 1].phase != history[k].phase))
      ends.push_back(history[k]);
  return ends;
}

/// Whether all elastic energy must be back: nothing touches any more, and nothing did at the start.
bool is_apart(const Press& one, const Motion& motion) {
  const auto& network = motion.network();
  if (!dynamics::conserves(one.model) || motion.history().front().contacts > 0) return false;
  if (network.contacts().touching() > 0 || !network.walls().empty()) return false;
  std::vector<dynamics::WallContact> walls;
  dynamics::find_wall_contacts(one.model.box, one.model.box.max.z, one.state.position, one.particles.radius,
                               walls);
  return walls.empty();
}

MotionRecord::Parts parts_of(const dynamics::PartTimes& times, double total) {
  const double known = times.contacts + times.forces + times.heat + times.current;
  return {times.contacts, times.forces, times.heat, times.current, std::max(total - known, 0.0)};
}

MotionRecord motion_of(const Press& one, const Motion& motion, const SinteringResult& result) {
  const Vec3 &low = one.model.box.min, &high = one.model.box.max;
  MotionRecord record{.box_min = {low.x, low.y, low.z},
                      .box_max = {high.x, high.y, high.z},
                      .snapshots = {},
                      .phase_ends = {},
                      .iterations = motion.iterations(),
                      .neighbour_lists = motion.network().contacts().list().builds(),
                      .cpu_parts = parts_of(motion.network().times, result.cpu_stepping)};
  for (const auto& snapshot : result.snapshots)
    record.snapshots.push_back({snapshot.file, snapshot.time, snapshot.upper_wall});
  for (const auto& row : phase_ends(motion.history()))
    record.phase_ends.push_back({.phase = phase_name(one, row),
                                 .time = row.time,
                                 .volume_fraction = row.volume_fraction,
                                 .mean_temperature = row.mean_temperature,
                                 .max_temperature = row.max_temperature,
                                 .wall_force = row.wall_force,
                                 .bonds = static_cast<std::size_t>(row.bonds),
                                 .contacts = static_cast<std::size_t>(row.contacts)});
  return record;
}

RunRecord record_of(const Press& one, const Motion& motion, const SinteringResult& result, int threads) {
  const std::string& spec = one.stepping.thermal_integrator;
  const bool plain = one.stepping.scheme == dynamics::SteppingSettings::Scheme::plain;
  const auto* bridge = motion.bridge();
  RunRecord record;
  record.version = program_version();
  record.revision = program_revision();
  record.case_name = one.name;
  record.title = one.title;
  record.source = one.source;
  record.integrator = plain ? "plain" : "staggered";
  record.params = fmt::format("{}{}", spec.empty() ? "" : "thermal_integrator=", spec);
  record.status = status_name(result.outcome.status);
  record.reason = result.outcome.reason;
  record.t_end = one.t_end;
  record.t_reached = motion.state().time;
  record.nodes = one.particles.size();
  record.contacts = static_cast<std::size_t>(motion.history().back().contacts);
  record.unknowns = 7 * one.particles.size();
  record.steps = motion.history().size() - 1;
  record.rejected = motion.rejected();
  record.rhs = bridge ? bridge->sweeps() : motion.iterations();
  if (bridge) {
    record.jacobians = bridge->jacobians();
    record.factorizations = bridge->factorizations();
    record.solves = bridge->solves();
    record.max_stages = bridge->max_stages();
  }
  record.potential_solves = motion.network().current().potential_solves();
  record.threads = threads;
  record.cpu_setup = result.cpu_setup;
  record.cpu_stepping = result.cpu_stepping;
  record.wall_stepping = result.wall_stepping;
  record.peak_memory_mb = peak_memory_megabytes();
  record.files = result.files;
  record.warnings = result.warnings;
  if (one.model.electric.model == dynamics::CurrentModel::none)
    record.skips.push_back({"electric field", "the case has no [electric]"});
  if (!(one.model.bond.stiffness > 0))
    record.skips.push_back({"bonds", "the case has no [dynamics.bond], or its stiffness is 0"});
  record.machine = machine_facts();
  record.libraries = library_facts();
  record.motion = motion_of(one, motion, result);
  return record;
}

}  // namespace

std::string history_csv(const Press& one, std::span<const HistoryRow> history) {
  std::string out =
      "time,phase,volume_fraction,mean_temperature,max_temperature,wall_force,kinetic_energy,bonds,"
      "contacts,step,iterations,rejections,wall_work,potential_energy,elastic_energy,dissipated,joule_heat,"
      "heat_lost,heat_content,landed\n";
  for (const auto& row : history)
    append(out, "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.time,
           csv_cell(phase_name(one, row)), row.volume_fraction, row.mean_temperature, row.max_temperature,
           row.wall_force, row.kinetic_energy, row.bonds, row.contacts, row.step, row.iterations,
           row.rejections, row.wall_work, row.potential_energy, row.elastic_energy, row.dissipated,
           row.joule_heat, row.heat_lost, row.heat_content, row.landed);
  return out;
}

std::string particles_csv(const Press& one, const dynamics::State& state) {
  const auto model = one.model.electric.model;
  const bool electric = model != dynamics::CurrentModel::none;
  std::string out;
  append(out, "id,x,y,z,r{},temperature,vx,vy,vz\n",
         !electric                                    ? ""
         : model == dynamics::CurrentModel::averaging ? ",current"
                                                      : ",potential");
  std::vector<std::size_t> order(state.size());
  std::iota(order.begin(), order.end(), 0);
  const auto& id = one.particles.id;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return id[a] < id[b]; });
  for (const std::size_t i : order) {
    const Vec3 &at = state.position[i], &v = state.velocity[i];
    append(out, "{},{},{},{},{}", id[i], at.x, at.y, at.z, one.particles.radius[i]);
    if (electric) append(out, ",{}", state.electric[i]);
    append(out, ",{},{},{},{}\n", state.temperature[i], v.x, v.y, v.z);
  }
  return out;
}

std::string sintering_json(const Press& one, const Motion& motion, const SinteringResult& result,
                           int threads) {
  return run_json(record_of(one, motion, result, threads));
}

std::string sintering_summary(const Press& one, const Motion& motion, const SinteringResult& result,
                              const std::string& folder) {
  std::string text;
  const std::string scheme =
      one.stepping.scheme == dynamics::SteppingSettings::Scheme::plain ? "plain" : "staggered";
  text += fmt::format("{}{}{}: {}{}{}\n", scheme, one.stepping.thermal_integrator.empty() ? "" : " + ",
                      one.stepping.thermal_integrator, status_name(result.outcome.status),
                      result.outcome.ok() ? "" : ": ", result.outcome.reason);
  text += fmt::format("{:<12} {:>8} {:>9} {:>8} {:>8} {:>11} {:>7} {:>9}\n", "phase", "end [s]", "fraction",
                      "mean [K]", "max [K]", "wall [N]", "bonds", "contacts");
  for (const auto& row : phase_ends(motion.history()))
    text += fmt::format("{:<12} {:>8.4g} {:>9.4f} {:>8.1f} {:>8.1f} {:>11.4g} {:>7} {:>9}\n",
                        phase_name(one, row), row.time, row.volume_fraction, row.mean_temperature,
                        row.max_temperature, row.wall_force, row.bonds, row.contacts);
  text += fmt::format(
      "{} ({} made again, shorter), {}, {:.3g} s CPU:", quantity(motion.history().size() - 1, "step"),
      quantity(motion.rejected(), "attempt failed and was", "attempts failed and were"),
      quantity(motion.iterations(), "iteration"), result.cpu_stepping);
  const auto parts = parts_of(motion.network().times, result.cpu_stepping);
  const auto percent = [&](double seconds) {
    return result.cpu_stepping > 0 ? 100 * seconds / result.cpu_stepping : 0.0;
  };
  text += fmt::format(" contacts {:.0f} % forces {:.0f} % heat {:.0f} % current {:.0f} % rest {:.0f} %",
                      percent(parts.contacts), percent(parts.forces), percent(parts.heat),
                      percent(parts.current), percent(parts.rest));
  const auto errors = dynamics::balance_errors(motion.history(), is_apart(one, motion));
  text += fmt::format("\nenergy balance of what was turned over: motion closes to {:.1e}, heat to {:.1e}",
                      errors.mechanical, errors.thermal);
  return text + fmt::format("\n{}\n", folder);
}

}  // namespace superstep
