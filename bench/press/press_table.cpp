#include "bench/press/press_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "dynamics/volume_fraction.hpp"
#include "integrators/press/motion.hpp"

namespace superstep {
namespace {

using dynamics::Model;
using dynamics::Motion;
using dynamics::Phase;

/// Number of the phase that holds: it follows the one that presses furthest, and its wall stands.
std::size_t hold_phase(const Press& one) {
  const auto& phases = one.model.schedule.phases();
  const double lowest = one.model.schedule.lowest_wall();
  for (std::size_t k = 0; k + 2 < phases.size(); ++k)
    if (phases[k].upper_wall == lowest && phases[k + 1].upper_wall == lowest) return k + 1;
  throw InputError(
      fmt::format("{}: [bench.press_table] needs a phase that presses, one that holds and one that releases, "
                  "in this order",
                  one.file));
}

/// The press with another lowest height and another hold.
Model variant(const Press& one, std::size_t hold, double height, double duration) {
  auto phases = one.model.schedule.phases();
  phases[hold - 1].upper_wall = phases[hold].upper_wall_begin = phases[hold].upper_wall =
      phases[hold + 1].upper_wall_begin = height;
  const double later = phases[hold].begin + duration - phases[hold].end;
  phases[hold].end += later;
  for (std::size_t k = hold + 1; k < phases.size(); ++k) {
    phases[k].begin += later;
    phases[k].end += later;
  }
  Model model = one.model;
  model.schedule = dynamics::Schedule(std::move(phases));
  return model;
}

/// Lets go of a bed that has been held.
void release(const Press& bed, const Model& model, const Motion& held, const std::atomic<bool>* stop,
             PressTableRow& row) {
  const auto fraction = [&](const dynamics::State& state) {
    return dynamics::volume_fraction(model.box, row.upper_wall, state.position, bed.particles.radius);
  };
  Motion motion(model, bed.particles, bed.stepping);
  motion.stop = stop;
  motion.resume(held.state(), held.next_step(), {});
  const Outcome outcome = motion.advance(model.schedule.phases().back().end);
  row.status = status_name(outcome.status);
  row.reason = outcome.reason;
  if (!outcome.ok()) return;
  row.pressed = fraction(held.state());
  row.temperature_hold = held.history().back().mean_temperature;
  row.released = fraction(motion.state());
  row.temperature_end = motion.history().back().mean_temperature;
  row.bonds = static_cast<std::uint64_t>(motion.history().back().bonds);
}

/// One bed, pressed to one height; each hold is cut out of the longest one.
void press_bed(const Press& bed, std::size_t hold, const Motion& poured, std::uint64_t seed, double wall,
               const std::vector<double>& holds, const std::atomic<bool>* stop,
               std::vector<PressTableRow>& rows) {
  const Model longest = variant(bed, hold, wall, holds.back());
  Motion press(longest, bed.particles, bed.stepping);
  press.stop = stop;
  press.resume(poured.state(), poured.next_step(), {});
  Outcome outcome;
  for (const double duration : holds) {
    PressTableRow& row = rows.emplace_back();
    row.case_name = bed.name;
    row.seed = seed;
    row.upper_wall = wall;
    row.hold = duration;
    row.poured = dynamics::volume_fraction(longest.box, wall, poured.state().position, bed.particles.radius);
    const Model model = variant(bed, hold, wall, duration);
    if (outcome.ok()) outcome = press.advance(model.schedule.phases()[hold].end);
    row.status = status_name(outcome.status);
    row.reason = outcome.reason;
    if (outcome.ok()) release(bed, model, press, stop, row);
  }
}

const Press::Table& table_of(const Press& one) {
  if (one.table) return *one.table;
  throw InputError(fmt::format(
      "{}: has no [bench.press_table]; give it hold = [s, ...], upper_wall = [m, ...] and, where particles "
      "are generated, seeds = [...]",
      one.file));
}

void check_heights(const Press& one, double highest) {
  for (const double wall : one.table->walls)
    if (!(wall > one.model.box.min.z && wall <= highest))
      throw InputError(fmt::format(
          "{}: [bench.press_table] upper_wall has {} m; it must lie between the floor at {} m and the {} m "
          "where the pressing begins",
          one.file, wall, one.model.box.min.z, highest));
}

}  // namespace

std::vector<PressTableRow> press_table(const Press& one, const std::atomic<bool>* stop, Progress& progress) {
  const Press::Table& table = table_of(one);
  const std::size_t hold = hold_phase(one);
  check_heights(one, one.model.schedule.phases()[hold - 1].upper_wall_begin);
  auto holds = table.holds;
  std::sort(holds.begin(), holds.end());
  const bool generated = !table.seeds.empty();
  const auto seeds = generated ? table.seeds : std::vector<std::int64_t>{0};
  std::vector<PressTableRow> rows;
  progress.begin(one.name + ": press table", static_cast<double>(seeds.size() * table.walls.size()));
  for (const std::int64_t number : seeds) {
    const auto seed = static_cast<std::uint64_t>(number);
    const Press bed = generated ? load_press(one.file, seed) : one;
    Motion pour(bed.model, bed.particles, bed.stepping);
    pour.stop = stop;
    pour.start(bed.state);
    const Outcome outcome = pour.advance(bed.model.schedule.phases()[hold - 1].begin);
    if (outcome.status == Status::interrupted) break;
    if (!outcome.ok())
      throw NumericalError(fmt::format("{}: pouring{}: {}", one.name,
                                       generated ? fmt::format(" with seed {}", seed) : "", outcome.reason));
    for (const double wall : table.walls) {
      press_bed(bed, hold, pour, seed, wall, holds, stop, rows);
      progress.reached(static_cast<double>(rows.size()) / static_cast<double>(holds.size()));
    }
  }
  progress.end();
  return rows;
}

}  // namespace superstep
