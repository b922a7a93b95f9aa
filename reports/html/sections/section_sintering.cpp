/// Runs of moving particles: how a bed was poured, pressed, heated and released.
/// Source of the curves: figures 8 and 9 of Zohdi (2014), Math. Mech. Solids 19, 93-113.

#include <fmt/format.h>

#include <algorithm>

#include "reports/chart/chart.hpp"
#include "reports/chart/chart_particles.hpp"
#include "reports/html/html_parts.hpp"
#include "reports/html/sections/sections.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

using Runs = std::vector<const RunInput*>;
using Values = std::vector<double> MotionHistory::*;

std::string name_of(const RunInput& run) {
  return run.record.title.empty() ? run.record.case_name : run.record.title;
}

std::string label_of(const RunInput& run) {
  return run.folder == "." ? "this folder" : run.folder;
}

std::string percent_text(double fraction) {
  return number_text(100 * fraction) + " %";
}

/// By how much of its largest value the volume fraction has fallen by the end; 0 where there is none.
double springback(const MotionInput& motion) {
  return motion.largest_fraction > 0 ? 1 - motion.phases.back().volume_fraction / motion.largest_fraction : 0;
}

std::uint64_t most_bonds(const MotionInput& motion) {
  std::uint64_t most = 0;
  for (const auto& phase : motion.phases) most = std::max(most, phase.bonds);
  return most;
}

std::vector<ChartSpan> spans_of(const MotionInput& motion, const TimeUnit& unit) {
  std::vector<ChartSpan> spans;
  for (const auto& phase : motion.phases)
    spans.push_back({phase.name, phase.begin * unit.factor, phase.end * unit.factor});
  return spans;
}

std::vector<double> times_of(const MotionInput& motion, const TimeUnit& unit) {
  std::vector<double> times = motion.history.time;
  for (double& t : times) t *= unit.factor;
  return times;
}

struct Quantity {
  const char* name;
  Values values;
};

/// Curves of one run with its phases.
std::string run_chart(const RunInput& run, const std::string& id, const char* title, const char* caption,
                      const char* axis, std::span<const Quantity> quantities) {
  const TimeUnit unit = time_unit(run.record.t_end);
  Chart chart{.id = id,
              .title = title,
              .caption = caption,
              .x = {.label = fmt::format("time [{}]", unit.name)},
              .y = {.label = axis},
              .spans = spans_of(*run.motion, unit)};
  for (const auto& quantity : quantities) {
    Look look = curve_look(chart.series.size());
    look.marker = Marker::none;
    chart.series.push_back({.name = quantity.name,
                            .look = look,
                            .in_legend = quantities.size() > 1,
                            .x = times_of(*run.motion, unit),
                            .y = run.motion->history.*quantity.values});
  }
  return chart_figure(chart);
}

std::string run_charts(const RunInput& run, const std::string& id) {
  constexpr Quantity fraction[] = {{"volume fraction", &MotionHistory::volume_fraction}};
  constexpr Quantity heat[] = {{"mean", &MotionHistory::mean_temperature},
                               {"hottest particle", &MotionHistory::max_temperature}};
  constexpr Quantity force[] = {{"wall force", &MotionHistory::wall_force}};
  constexpr Quantity pairs[] = {{"contacts", &MotionHistory::contacts}, {"bonds", &MotionHistory::bonds}};
  return figure_row(
      run_chart(run, id + "-fraction", "Volume fraction",
                "Of the box below the lowest position of the upper wall; overlaps count twice.",
                "volume fraction", fraction) +
      run_chart(run, id + "-temperature", "Temperature", "Mean over the particles, and of the hottest one.",
                "temperature [K]", heat) +
      run_chart(run, id + "-force", "Force on the upper wall", "Normal to it.", "force [N]", force) +
      run_chart(run, id + "-pairs", "Contacts and bonds",
                "Pairs that touch, and those of them that stick together.", "pairs", pairs));
}

/// Where energy came from and where it went; empty where the program that ran kept no account.
std::string energy_charts(const RunInput& run, const std::string& id) {
  const MotionHistory& history = run.motion->history;
  if (history.wall_work.empty() || history.heat_gained.empty()) return {};
  constexpr Quantity motion[] = {{"work of the wall", &MotionHistory::wall_work},
                                 {"elastic: contacts and necks", &MotionHistory::elastic},
                                 {"dissipated", &MotionHistory::dissipated},
                                 {"kinetic", &MotionHistory::kinetic},
                                 {"potential: weight", &MotionHistory::potential}};
  constexpr Quantity heat[] = {{"heat of the current", &MotionHistory::joule_heat},
                               {"gained by the particles", &MotionHistory::heat_gained},
                               {"lost to the walls", &MotionHistory::heat_lost}};
  return figure_row(
      run_chart(run, id + "-energy", "Energy of the motion",
                "Since the start. The wall's work is what the other curves add up to.", "energy [J]",
                motion) +
      run_chart(run, id + "-heat", "Heat",
                "Since the start. The heat of the current is gained by the particles or lost to the walls.",
                "heat [J]", heat));
}

std::string phase_table(const MotionInput& motion) {
  HtmlTable table({{"phase", "", false},
                   {"from [s]"},
                   {"to [s]"},
                   {"volume fraction", "at the end of the phase"},
                   {"mean temperature [K]", "at the end of the phase"},
                   {"hottest particle [K]", "at the end of the phase"},
                   {"force on the upper wall [N]", "at the end of the phase"},
                   {"largest force [N]", "during the phase"},
                   {"bonds", "at the end of the phase"},
                   {"contacts", "at the end of the phase"},
                   {"steps", "accepted during the phase"}},
                  false);
  const auto count_cell = [](std::uint64_t value) { return HtmlTable::Cell{.text = count_text(value)}; };
  for (const auto& phase : motion.phases)
    table.add_row({{.text = phase.name, .kind = "strong"},
                   number_cell(Number(phase.begin)),
                   number_cell(Number(phase.end)),
                   number_cell(Number(phase.volume_fraction), 4),
                   number_cell(Number(phase.mean_temperature), 4),
                   number_cell(Number(phase.max_temperature), 4),
                   number_cell(Number(phase.wall_force)),
                   number_cell(Number(phase.largest_wall_force)),
                   count_cell(phase.bonds),
                   count_cell(phase.contacts),
                   count_cell(phase.steps)});
  return table.html();
}

std::string outcome_of(const RunInput& run) {
  const auto& record = run.record;
  const MotionInput& motion = *run.motion;
  std::string out;
  if (record.status != "ok")
    out += fmt::format("<p class=\"notice\">{} at {}: {}</p>\n", html_text(record.status),
                       html_text(number_text(record.t_reached) + " s"), html_text(record.reason));
  const MotionPhase& last = motion.phases.back();
  return out +
         fact_list(
             {{"particles", count_text(record.nodes)},
              {"simulated time", number_text(record.t_reached, 4) + " s"},
              {"largest volume fraction", fmt::format("{} at {} s", number_text(motion.largest_fraction, 4),
                                                      number_text(motion.largest_fraction_at, 4))},
              {"volume fraction at the end", number_text(last.volume_fraction, 4)},
              {"springback: lost of the largest volume fraction", percent_text(springback(motion))},
              {"bonds at the end", count_text(last.bonds)},
              {"steps, restarted ones", count_text(record.steps) + ", " + count_text(record.rejected)},
              {"CPU time of stepping", number_text(record.cpu_stepping) + " s"}});
}

/// One run: an article of the page.
std::string run_article(const RunInput& run, const std::string& id, bool only) {
  std::string title = only ? "Sintering" : "Sintering: " + name_of(run);
  if (!only && run.folder != ".") title += " (" + run.folder + ")";
  std::string out = fmt::format("<article id=\"{}\">\n<h2>{}</h2>\n", id, html_text(title));
  out += html_section(id + "-phases", "Phase by phase",
                      "What the press did one after the other, and what the particles were like when each "
                      "phase ended.",
                      outcome_of(run) + phase_table(*run.motion));
  out += html_section(id + "-history", "Over time", "Phases are shaded in turn and named above each chart.",
                      run_charts(run, id) + energy_charts(run, id));
  out += html_section(id + "-pictures", "Pictures", "", particles_figures(*run.motion, id + "-particles"));
  return out + "</article>\n";
}

std::string comparison_table(const Runs& runs) {
  HtmlTable table({{"run", "folder below that of the report", false},
                   {"status", "", false},
                   {"largest volume fraction"},
                   {"volume fraction at the end"},
                   {"springback [%]", "how much of the largest volume fraction was lost by the end"},
                   {"most bonds", "at the end of a phase"},
                   {"bonds at the end"},
                   {"mean temperature at the end [K]"},
                   {"CPU stepping [s]"}},
                  true);
  for (const auto* run : runs) {
    const MotionInput& motion = *run->motion;
    const MotionPhase& last = motion.phases.back();
    table.add_row({{.text = label_of(*run), .kind = "strong", .hint = name_of(*run)},
                   {.text = run->record.status,
                    .kind = run->record.status == "ok" ? "good" : "bad",
                    .hint = run->record.reason},
                   number_cell(Number(motion.largest_fraction), 4),
                   number_cell(Number(last.volume_fraction), 4),
                   number_cell(Number(100 * springback(motion))),
                   number_cell(Number(static_cast<double>(most_bonds(motion))), 6),
                   number_cell(Number(static_cast<double>(last.bonds)), 6),
                   number_cell(Number(last.mean_temperature), 4),
                   number_cell(Number(run->record.cpu_stepping))});
  }
  return table.html();
}

std::string comparison_chart(const Runs& runs, const char* id, const char* title, const char* axis,
                             Values values) {
  double end = 0;
  for (const auto* run : runs) end = std::max(end, run->record.t_end);
  const TimeUnit unit = time_unit(end);
  Chart chart{.id = id,
              .title = title,
              .caption = "",
              .x = {.label = fmt::format("time [{}]", unit.name)},
              .y = {.label = axis}};
  for (const auto* run : runs)
    chart.series.push_back({.name = label_of(*run),
                            .look = curve_look(chart.series.size()),
                            .x = times_of(*run->motion, unit),
                            .y = run->motion->history.*values});
  return chart_figure(chart);
}

std::string comparison_article(const Runs& runs) {
  const std::string charts =
      comparison_chart(runs, "sintering-compared-fraction", "Volume fraction", "volume fraction",
                       &MotionHistory::volume_fraction) +
      comparison_chart(runs, "sintering-compared-temperature", "Mean temperature", "temperature [K]",
                       &MotionHistory::mean_temperature) +
      comparison_chart(runs, "sintering-compared-force", "Force on the upper wall", "force [N]",
                       &MotionHistory::wall_force) +
      comparison_chart(runs, "sintering-compared-bonds", "Bonds", "bonds", &MotionHistory::bonds);
  return "<article id=\"sintering\">\n<h2>Sintering</h2>\n" +
         html_section(
             "sintering-compared", "Runs compared",
             "Springback is the part of the largest volume fraction that is lost by the end of a run.",
             comparison_table(runs) + figure_row(charts)) +
         "</article>\n";
}

}  // namespace

std::string sintering_articles(std::span<const RunInput> runs) {
  Runs moving;
  for (const auto& run : runs)
    if (run.motion) moving.push_back(&run);
  std::string out;
  if (moving.size() > 1) out += comparison_article(moving);
  for (std::size_t k = 0; k < moving.size(); ++k)
    out += run_article(*moving[k], fmt::format("sintering-{}", k + 1), moving.size() == 1);
  return out;
}

}  // namespace superstep
