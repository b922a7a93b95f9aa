#include "bench/press/press_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/error.hpp"
#include "dynamics/volume_fraction.hpp"
#include "integrators/press/motion.hpp"
#include "results/text/csv_text.hpp"

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

PressTableRow released(const Press& bed, const Model& model, const Motion& held, PressTableRow row,
                       double height) {
  const auto fraction = [&](const dynamics::State& state) {
    return dynamics::volume_fraction(model.box, height, state.position, bed.particles.radius);
  };
  row.pressed = fraction(held.state());
  row.temperature_hold = held.history().back().mean_temperature;
  Motion motion(model, bed.particles, bed.stepping);
  motion.resume(held.state(), held.next_step(), {});
  const Outcome outcome = motion.advance(model.schedule.phases().back().end);
  row.status = status_name(outcome.status);
  row.reason = outcome.reason;
  row.released = fraction(motion.state());
  row.temperature_end = motion.history().back().mean_temperature;
  row.bonds = motion.history().back().bonds;
  return row;
}

struct PressCell {
  double upper_wall, hold, mean = 0, spread = 0, drop = 0, points = 0, poured = 0, pressed = 0, cooling = 0;
  int runs = 0;
};

template <class Value>
std::vector<double> distinct(const std::vector<PressTableRow>& rows, Value value) {
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(value(row));
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}
double hold_of(const PressTableRow& row) {
  return row.hold;
}
double wall_of(const PressTableRow& row) {
  return row.upper_wall;
}

PressCell cell_of(const std::vector<PressTableRow>& rows, double wall, double hold) {
  PressCell cell{wall, hold};
  for (const auto& row : rows) {
    if (row.upper_wall != wall || row.hold != hold || row.status != "ok") continue;
    cell.mean += row.springback();
    cell.drop += row.porosity_drop();
    cell.points += row.porosity_points();
    cell.poured += row.poured;
    cell.pressed += row.pressed;
    cell.cooling += row.temperature_hold - row.temperature_end;
    ++cell.runs;
  }
  for (double* sum : {&cell.mean, &cell.drop, &cell.points, &cell.poured, &cell.pressed, &cell.cooling})
    *sum /= std::max(cell.runs, 1);
  for (const auto& row : rows)
    if (row.upper_wall == wall && row.hold == hold && row.status == "ok")
      cell.spread = std::max(cell.spread, std::abs(row.springback() - cell.mean));
  return cell;
}

/// Pairs of neighbours along one axis between which springback falls, and how many there are.
template <class Fixed, class Along>
std::pair<int, int> falling(const std::vector<PressTableRow>& rows, Fixed fixed, Along along, bool upwards) {
  int fall = 0, all = 0;
  for (const auto& a : rows) {
    const PressTableRow* next = nullptr;
    for (const auto& b : rows)
      if (b.seed == a.seed && fixed(b) == fixed(a) && (upwards ? along(b) > along(a) : along(b) < along(a)) &&
          (!next || (upwards ? along(b) < along(*next) : along(b) > along(*next))))
        next = &b;
    if (!next || a.status != "ok" || next->status != "ok") continue;
    ++all;
    fall += next->springback() < a.springback() ? 1 : 0;
  }
  return {fall, all};
}

}  // namespace

std::vector<PressTableRow> press_table(const Press& one, Progress& progress) {
  if (!one.table)
    throw InputError(fmt::format(
        "{}: has no [bench.press_table]; give it hold = [s, ...], upper_wall = [m, ...] and seeds = [...]",
        one.file));
  const std::size_t hold = hold_phase(one);
  const double highest = one.model.schedule.phases()[hold - 1].upper_wall_begin;
  for (const double wall : one.table->walls)
    if (!(wall > one.model.box.min.z && wall <= highest))
      throw InputError(fmt::format(
          "{}: [bench.press_table] upper_wall has {} m; it must lie between the floor at {} m and the {} m "
          "where the pressing begins",
          one.file, wall, one.model.box.min.z, highest));
  auto holds = one.table->holds;
  std::sort(holds.begin(), holds.end());
  std::vector<PressTableRow> rows;
  const double beds = static_cast<double>(one.table->seeds.size() * one.table->walls.size());
  progress.begin(one.name + ": press table", beds);
  for (const std::int64_t seed : one.table->seeds) {
    const Press bed = load_press(one.file, static_cast<std::uint64_t>(seed));
    Motion pour(bed.model, bed.particles, bed.stepping);
    pour.start(bed.state);
    const double begin = bed.model.schedule.phases()[hold - 1].begin;
    if (const Outcome outcome = pour.advance(begin); !outcome.ok())
      throw NumericalError(fmt::format("{}: pouring with seed {}: {}", one.name, seed, outcome.reason));
    for (const double wall : one.table->walls) {
      const Model longest = variant(bed, hold, wall, holds.back());
      Motion press(longest, bed.particles, bed.stepping);
      press.resume(pour.state(), pour.next_step(), {});
      for (const double duration : holds) {
        PressTableRow row;
        row.seed = seed;
        row.upper_wall = wall;
        row.hold = duration;
        row.poured =
            dynamics::volume_fraction(longest.box, wall, pour.state().position, bed.particles.radius);
        const Model model = variant(bed, hold, wall, duration);
        const Outcome outcome = press.advance(model.schedule.phases()[hold].end);
        if (outcome.ok()) {
          row = released(bed, model, press, row, wall);
        } else {
          row.status = status_name(outcome.status);
          row.reason = outcome.reason;
        }
        rows.push_back(row);
      }
      const double share = static_cast<double>(rows.size()) / static_cast<double>(holds.size());
      progress.reached(share);
    }
  }
  progress.end();
  return rows;
}

std::string press_table_text(const std::vector<PressTableRow>& rows) {
  std::string text =
      fmt::format("{:>14} {:>9} {:>5} {:>8} {:>8} {:>22} {:>30} {:>9}\n", "upper wall [m]", "hold [s]",
                  "runs", "poured", "pressed", "springback, +- seeds", "porosity below poured", "cools [K]");
  for (const double wall : distinct(rows, wall_of))
    for (const double hold : distinct(rows, hold_of)) {
      const PressCell cell = cell_of(rows, wall, hold);
      text += fmt::format(
          "{:>14.4g} {:>9.4g} {:>5} {:>8.4f} {:>8.4f} {:>13.4f} +- {:.4f} {:>11.1f} % or {:>5.1f} points "
          "{:>9.1f}\n",
          wall, hold, cell.runs, cell.poured, cell.pressed, cell.mean, cell.spread, 100 * cell.drop,
          100 * cell.points, cell.cooling);
    }
  const auto by_hold = falling(rows, wall_of, hold_of, true),
             by_wall = falling(rows, hold_of, wall_of, false);
  text += fmt::format(
      "less springback with longer hold in {} of {} pairs, with higher densification in {} of {}\n",
      by_hold.first, by_hold.second, by_wall.first, by_wall.second);
  return text;
}

std::string press_table_csv(const Press& one, const std::vector<PressTableRow>& rows) {
  std::string out =
      "case,seed,upper_wall,hold,status,reason,fraction_poured,fraction_pressed,fraction_released,springback,"
      "porosity_drop_relative,porosity_drop_points,temperature_hold,temperature_end,bonds\n";
  for (const auto& row : rows)
    fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                   csv_cell(one.name), row.seed, row.upper_wall, row.hold, row.status, csv_cell(row.reason),
                   row.poured, row.pressed, row.released, row.springback(), row.porosity_drop(),
                   row.porosity_points(), row.temperature_hold, row.temperature_end, row.bonds);
  return out;
}

std::string press_table_svg(const std::vector<PressTableRow>& rows) {
  const auto walls = distinct(rows, wall_of), holds = distinct(rows, hold_of);
  double low = 1, high = 0;
  for (const double wall : walls)
    for (const double hold : holds) {
      const PressCell cell = cell_of(rows, wall, hold);
      low = std::min(low, cell.mean);
      high = std::max(high, cell.mean);
    }
  constexpr double side = 110, left = 120, top = 40;
  const double width = left + side * static_cast<double>(holds.size()) + 20,
               height = top + 60 * static_cast<double>(walls.size()) + 50;
  std::string out = fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="white"/>)",
      width, height);
  const auto put = [&](double x, double y, const char* anchor, const std::string& text) {
    out += fmt::format(R"(<text x="{}" y="{}" text-anchor="{}">{}</text>)", x, y, anchor, text);
  };
  put(left, 20, "start", "springback, mean over seeds and its spread");
  for (std::size_t row = 0; row < walls.size(); ++row) {
    const double y = top + 60 * static_cast<double>(row);
    put(left - 8, y + 34, "end", fmt::format("wall at {:.4g} m", walls[row]));
    for (std::size_t column = 0; column < holds.size(); ++column) {
      const PressCell cell = cell_of(rows, walls[row], holds[column]);
      const double x = left + side * static_cast<double>(column);
      const double part = high > low ? (cell.mean - low) / (high - low) : 0.5;
      out += fmt::format(
          R"svg(<rect x="{}" y="{}" width="{}" height="58" fill="rgb({:.0f},{:.0f},{:.0f})"/>)svg", x, y,
          side - 2, 232 - 12 * (1 - part), 240 - 110 * part, 240 - 150 * part);
      put(x + side / 2, y + 28, "middle", fmt::format("{:.2f} %", 100 * cell.mean));
      put(x + side / 2, y + 44, "middle", fmt::format("+- {:.2f}", 100 * cell.spread));
    }
  }
  for (std::size_t column = 0; column < holds.size(); ++column)
    put(left + side * (static_cast<double>(column) + 0.5), height - 28, "middle",
        fmt::format("{:.4g} s", holds[column]));
  put(left + side * 0.5 * static_cast<double>(holds.size()), height - 10, "middle", "hold");
  return out + "</svg>\n";
}

}  // namespace superstep
