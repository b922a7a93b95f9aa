#include "results/study/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text/quantity.hpp"
#include "results/text/csv_text.hpp"
#include "results/text/text_table.hpp"

namespace superstep {
namespace {

constexpr int loosest_level = -1, tightest_level = -10;  // powers of ten

// `auto` is one of the others under another name, so it cannot win against it.
bool competes(const WorkPrecisionPoint& point) {
  return point.ok() && point.cpu && point.integrator != "auto";
}

bool is_euler(const WorkPrecisionPoint& point) {
  return point.integrator == "forward-euler";
}

/// Cheapest point among those that `eligible` accepts.
template <class Eligible>
const WorkPrecisionPoint* cheapest(const WorkPrecision& study, Eligible eligible) {
  const WorkPrecisionPoint* best = nullptr;
  for (const auto& point : study.points)
    if (competes(point) && eligible(point) && (!best || point.cpu->median < best->cpu->median)) best = &point;
  return best;
}

LevelWinner winner_at(const WorkPrecision& study, double level) {
  LevelWinner out;
  out.level = level;
  const auto reaches = [&](const WorkPrecisionPoint& point) { return point.worst_relative <= level; };
  out.winner = cheapest(study, reaches);
  if (!out.winner) return out;
  const double cpu = out.winner->cpu->median;
  out.runner_up = cheapest(
      study, [&](const auto& point) { return reaches(point) && point.family != out.winner->family; });
  if (out.runner_up) out.lead = out.runner_up->cpu->median / cpu;
  const auto* euler = cheapest(study, [&](const auto& point) { return is_euler(point) && reaches(point); });
  if (euler) out.over_euler = euler->cpu->median / cpu;
  const bool was_run = std::any_of(study.points.begin(), study.points.end(), is_euler);
  if (!euler) out.without_euler = was_run ? "Euler does not reach it" : "Euler was not run";
  return out;
}

std::string seconds(const std::optional<Timing>& timing) {
  return timing ? fmt::format("{:.3g}", timing->median) : "";
}

std::string points_table(const WorkPrecision& study, bool color) {
  std::vector<TextTable::Header> headers = {{"", "SPEC", TextTable::Align::left},
                                            {"", "status", TextTable::Align::left},
                                            {"", "sweeps"},
                                            {"", "CPU [s]"}};
  const std::string group = fmt::format("rms error [{}] at t [s]", study.unit);
  for (const double t : study.output_times) headers.push_back({group, fmt::format("{:g}", t)});
  TextTable table(headers);
  for (const auto& point : study.points) {
    std::vector<TextTable::Cell> cells = {{point.spec},
                                          {point.status, point.ok() ? Style::plain : Style::red}};
    cells.push_back({fmt::format("{}", point.sweeps)});
    cells.push_back({seconds(point.cpu)});
    for (std::size_t k = 0; k < study.output_times.size(); ++k)
      cells.push_back({k < point.error_rms.size() ? fmt::format("{:.2e}", point.error_rms[k]) : ""});
    table.add_row(std::move(cells));
  }
  return table.text(color);
}

std::string winners_table(const WorkPrecision& study, bool color) {
  TextTable table({{"", "error/span"},
                   {"", "fastest", TextTable::Align::left},
                   {"", "CPU [s]"},
                   {"", "next best", TextTable::Align::left},
                   {"", "lead"},
                   {"", "over Euler"}});
  for (const auto& level : winners(study)) {
    if (!level.winner) {
      table.add_row(
          {{fmt::format("{:.0e}", level.level)}, {"nobody reaches it", Style::dim}, {""}, {""}, {""}, {""}});
      continue;
    }
    table.add_row({{fmt::format("{:.0e}", level.level)},
                   {level.winner->spec, Style::bold},
                   {seconds(level.winner->cpu)},
                   {level.runner_up ? level.runner_up->spec : "nobody"},
                   {level.lead ? fmt::format("{:.2f}x", *level.lead) : ""},
                   {level.over_euler ? fmt::format("{:.3g}x", *level.over_euler) : level.without_euler}});
  }
  return table.text(color);
}

}  // namespace

std::string family_of(const Spec& spec) {
  std::string family = spec.name;
  for (const auto& [key, value] : spec.settings)
    if (key != "rtol" && key != "step" && key != "fraction" && key != "n")
      family.append(" ").append(key).append("=").append(value);
  return family;
}

std::vector<LevelWinner> winners(const WorkPrecision& study) {
  std::vector<LevelWinner> out;
  const double bar = study.reference_error && study.span > 0 ? *study.reference_error / study.span : 0;
  for (int power = loosest_level; power >= tightest_level; --power) {
    const double level = std::pow(10.0, power);
    if (level > bar) out.push_back(winner_at(study, level));
  }
  return out;
}

std::string work_precision_csv(const WorkPrecision& study) {
  std::string out =
      "case,integrator,params,status,reason,unknowns,repetitions,threads,sweeps,steps,cpu_s,cpu_min_s,cpu_"
      "max_s,"
      "error_worst,error_worst_relative,reference,reference_error";
  for (const double t : study.output_times) out += fmt::format(",error_rms_at_{}", t);
  out += "\n";
  for (const auto& point : study.points) {
    const auto timing = [&](double Timing::*part) {
      return point.cpu ? csv_cell((*point.cpu).*part) : std::string();
    };
    const auto error = [&](double value) {
      return point.error_rms.empty() ? std::string() : csv_cell(value);
    };
    out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", csv_cell(study.case_name),
                       csv_cell(point.integrator), csv_cell(point.params), csv_cell(point.status),
                       csv_cell(point.reason), study.unknowns, study.repetitions, study.threads, point.sweeps,
                       point.steps, timing(&Timing::median), timing(&Timing::min), timing(&Timing::max),
                       error(point.worst), error(point.worst_relative), csv_cell(study.reference),
                       study.reference_error ? csv_cell(*study.reference_error) : std::string());
    for (std::size_t k = 0; k < study.output_times.size(); ++k)
      out += fmt::format(",{}", k < point.error_rms.size() ? csv_cell(point.error_rms[k]) : std::string());
    out += "\n";
  }
  return out;
}

std::string work_precision_table(const WorkPrecision& study, bool color) {
  std::string out = fmt::format("{}: {}\nwork against error: {}, {}, {}\n", study.case_name, study.title,
                                quantity(study.unknowns, "unknown"),
                                quantity(study.repetitions, "repetition"), quantity(study.threads, "thread"));
  out += study.reference_error ? fmt::format("reference {}, error bar {:.1e} {} rms\n\n", study.reference,
                                             *study.reference_error, study.unit)
                               : fmt::format("reference {}, without an error bar\n\n", study.reference);
  out += points_table(study, color) +
         "\nFastest method for each error (worst output time, rms over the span)\n\n" +
         winners_table(study, color);
  for (const auto& point : study.points)
    if (!point.ok()) out += fmt::format("\n{}: {}: {}", point.spec, point.status, point.reason);
  return out + (out.ends_with('\n') ? "" : "\n");
}

}  // namespace superstep
