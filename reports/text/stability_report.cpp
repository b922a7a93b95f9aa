#include "reports/text/stability_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text/quantity.hpp"
#include "results/text/text_table.hpp"

namespace superstep {
namespace {

using Align = TextTable::Align;
using TextCell = TextTable::Cell;

std::string heading(std::string_view title, bool color) {
  return fmt::format("\n{}\n", styled(std::string(title), Style::bold, color));
}

std::string number(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "overflow";
}

std::string number(const std::optional<double>& value, const char* format) {
  return value ? number(*value, format) : "";
}

TextCell yes_no(bool yes) {
  return yes ? TextCell{"yes", Style::green} : TextCell{"no", Style::red};
}

TextCell stable_cell(Tendency tendency) {
  const Style style = tendency == Tendency::grows     ? Style::red
                      : tendency == Tendency::unclear ? Style::yellow
                                                      : Style::green;
  return {stable_word(tendency), style};
}

TextCell judged(std::string text, bool good) {
  return {std::move(text), good ? Style::plain : Style::red};
}

/// The orders of one STS parameter set, or of one (n, nu) of the rounding study, which follow each other.
template <class Row, class Same>
std::vector<std::vector<const Row*>> neighbours(const std::vector<Row>& rows, Same same) {
  std::vector<std::vector<const Row*>> groups;
  for (const auto& row : rows) {
    if (groups.empty() || !same(*groups.back().front(), row)) groups.emplace_back();
    groups.back().push_back(&row);
  }
  return groups;
}

std::string superstep_table(const StabilityResults& results, bool color) {
  TextTable table({{"", "parameters", Align::left},
                   {"", "H/h_cr"},
                   {"", "damping"},
                   {"R at the stiff end", "theory"},
                   {"R at the stiff end", "measured"},
                   {"largest |measured - R|", "recurrence"},
                   {"largest |measured - R|", "leja"},
                   {"largest |measured - R|", "natural"},
                   {"growth beyond, theory 2", "recurrence"},
                   {"growth beyond, theory 2", "leja"},
                   {"growth beyond, theory 2", "natural"}});
  std::vector<MethodStability> rows;
  for (const auto& method : results.methods)
    if (method.family == "sts") rows.push_back(method);
  const auto same = [](const auto& a, const auto& b) { return a.parameters == b.parameters; };
  for (const auto& set : neighbours(rows, same)) {
    const auto& first = *set.front();
    std::vector<TextCell> cells = {{first.parameters},
                                   {number(*first.beta / 2, "{:.4g}")},
                                   {number(first.damping, "{:.4f}")},
                                   {number(first.stiff, "{:.5f}")},
                                   {number(first.stiff_measured, "{:.5f}")}};
    for (const auto* one : set) cells.push_back(judged(number(one->difference, "{:.1e}"), one->agrees));
    for (const auto* one : set) cells.push_back(judged(number(one->beyond_measured, "{:.4g}"), one->agrees));
    table.add_row(std::move(cells));
  }
  return table.text(color);
}

std::string other_methods_table(const StabilityResults& results, bool color) {
  TextTable table({{"", "method", Align::left},
                   {"", "parameters", Align::left},
                   {"", "h rho"},
                   {"", "beta"},
                   {"", "limit/beta"},
                   {"", "max |R|"},
                   {"", "damping"},
                   {"R at the stiff end", "theory"},
                   {"R at the stiff end", "measured"},
                   {"", "|measured - R|"},
                   {"growth per step", "own step"},
                   {"growth per step", "beyond"},
                   {"", "agrees"}});
  for (const auto& m : results.methods) {
    if (m.family == "sts") continue;
    const std::string ratio = m.limit ? number(*m.limit / *m.beta, "{:.4f}") : "";
    table.add_row({{m.family},
                   {m.parameters},
                   {number(m.z_stiff, "{:.5g}")},
                   {number(m.beta, "{:.5g}")},
                   {ratio},
                   {number(m.largest, "{:.4f}")},
                   {number(m.damping, "{:.4f}")},
                   {number(m.stiff, "{:.5f}")},
                   {number(m.stiff_measured, "{:.5f}")},
                   {number(m.difference, "{:.1e}")},
                   {number(m.growth, "{:.4f}")},
                   {number(m.beyond_measured, "{:.4f}")},
                   yes_no(m.agrees)});
  }
  return table.text(color);
}

std::string methods_section(const StabilityResults& results, bool color) {
  if (results.methods.empty()) return "nothing limits the step of this network: no method examined\n";
  return "R(z) is what a step makes of a mode, z = step x rate, up to h rho = 0.99 beta. Measured: the "
         "stiffest "
         "mode of this network\nover steps of five lengths (tolerance 1e-9, more where that mode is not "
         "sharp); a "
         "white perturbation over several steps,\nat the method's own step (at most max |R|) and beyond the "
         "limit "
         "where |R| = 2 (within 1 %). Damping: max |R| over the\nstiffer half; limit: where |R| first "
         "exceeds "
         "1.\n\nSuper-time-stepping, three orders of the same substeps\n" +
         superstep_table(results, color) + "\n" + other_methods_table(results, color);
}

std::string critical_step_section(const CriticalStepStudy& study, bool color) {
  if (!std::isfinite(study.limit)) return "nothing limits the step of this network\n";
  TextTable table({{"", "estimate", Align::left},
                   {"", "step [s]"},
                   {"", "alpha"},
                   {"", "of the limit"},
                   {"", "growth"},
                   {"", "stable"},
                   {"", "", Align::left}});
  for (const auto& e : study.estimates)
    table.add_row({{e.name},
                   {number(e.step, "{:.5g}")},
                   {number(e.alpha, "{:.4f}")},
                   {number(e.of_limit, "{:.4f}")},
                   {number(e.growth, "{:.6f}")},
                   stable_cell(e.tendency),
                   {e.note}});
  return fmt::format(
             "{} runs of {} steps from the stiffest mode and white noise, slow modes taken away; growth: "
             "mean "
             "factor per step; alpha = step / pairwise step without interface. "
             "Lanczos over\nbisection: {:.4f} (agreement within 1 %: {}).\n\n",
             study.runs, study.steps_per_run, study.lanczos_ratio, study.agrees ? "yes" : "no") +
         table.text(color);
}

std::string rounding_section(const StabilityResults& results, bool color) {
  std::vector<TextTable::Header> headers = {{"", "nu"}, {"", "n"}};
  for (const char* measure : {"internal amplification", "one superstep [eps]", "end of a run [spans]"})
    for (const char* order : {"recurrence", "leja", "natural"}) headers.push_back({measure, order});
  headers.push_back({"", "end error [spans]"});
  TextTable table(headers);
  const auto same = [](const auto& a, const auto& b) { return a.n == b.n && a.nu == b.nu; };
  for (const auto& set : neighbours(results.rounding, same)) {
    std::vector<TextCell> cells = {{fmt::format("{:g}", set.front()->nu)},
                                   {fmt::format("{}", set.front()->n)}};
    for (const auto* one : set) cells.push_back({number(one->amplification, "{:.1e}")});
    for (const auto* one : set) cells.push_back({number(one->superstep_error, "{:.1e}")});
    for (const auto* one : set) cells.push_back(judged(number(one->rounding_error, "{:.1e}"), one->right));
    cells.push_back({number(set.front()->end_error, "{:.1e}")});
    table.add_row(std::move(cells));
  }
  return "On a chain of 300 nodes with known modes. Amplification: what one rounding can become inside a "
         "superstep. Then the\ndifference to the same supersteps done exactly, after one superstep and at "
         "the "
         "end of a run. End error: against the\nexact solution, order recurrence.\n\n" +
         table.text(color);
}

std::string sweeps_table(const std::vector<SweepPoint>& sweeps, bool color) {
  std::vector<TextTable::Header> headers = {{"", "sweep", Align::left},
                                            {"", "contrast"},
                                            {"", "size ratio"},
                                            {"", "nu"},
                                            {"bound / true rho", "edge"},
                                            {"bound / true rho", "Gershgorin"},
                                            {"", "alpha*"}};
  for (const auto& overshoot : sweeps.front().overshoots)
    headers.push_back({"overshoot [spans]", overshoot.method});
  TextTable table(headers);
  for (const auto& p : sweeps) {
    std::vector<TextCell> cells = {{p.sweep},
                                   {fmt::format("{:g}", p.contrast)},
                                   {fmt::format("{:g}", p.size_ratio)},
                                   {fmt::format("{:g}", p.nu)},
                                   {number(p.edge_ratio, "{:.3f}")},
                                   {number(p.gershgorin_ratio, "{:.3f}")},
                                   {number(p.alpha, "{:.3f}")}};
    for (const auto& overshoot : p.overshoots) cells.push_back({number(overshoot.spans, "{:.3f}")});
    table.add_row(std::move(cells));
  }
  return table.text(color);
}

std::string sweeps_section(const std::vector<SweepPoint>& sweeps, bool color) {
  const auto& first = sweeps.front();
  return fmt::format(
             "Random networks of {} nodes, worst of {}. alpha*: true critical step over the pairwise one. "
             "Overshoot: how far values\nleave the range of initial and fixed values within five steps from "
             "a "
             "start of zeros and ones; STS with n = {}, the other\nexplicit methods with 11 stages, all at "
             "0.99 "
             "of their limits; the phi rule at the superstep's length.\n\n",
             first.nodes, first.networks, first.n) +
         sweeps_table(sweeps, color);
}

std::string state_table(const FrozenState& state, bool color) {
  TextTable table({{"", "method", Align::left},
                   {"", "parameters", Align::left},
                   {"longest stable step [s]", "predicted"},
                   {"longest stable step [s]", "measured"},
                   {"", "predicted/measured"},
                   {"", "growth at predicted"},
                   {"", "", Align::left}});
  for (const auto& m : state.limits) {
    const bool differs = m.verdict == FrozenLimit::Verdict::differs;
    table.add_row({{m.family},
                   {m.parameters},
                   {number(m.predicted, "{:.5g}")},
                   {std::isfinite(m.measured) ? number(m.measured, "{:.5g}") : "none"},
                   {m.predicted ? number(*m.predicted / m.measured, "{:.4f}") : ""},
                   {number(m.growth_at_predicted, "{:.6f}")},
                   {differs ? "DIFFERS" : verdict_name(m.verdict), differs ? Style::red : Style::plain}});
  }
  return table.text(color);
}

std::string state_section(const FrozenState& state, bool color) {
  std::string out = fmt::format(
      "at {:g} % of the run, t = {:.6g} s: {}, {} spectrum ({}), |lambda| = {:.6g} 1/s", 100 * state.part,
      state.time, quantity(state.unknowns, "unknown"), state.spectrum, state.found_by, state.lambda_max);
  if (state.lambda_imaginary > 0) out += fmt::format(" (imaginary part {:.3g})", state.lambda_imaginary);
  out += fmt::format(", certified bound {:.6g} 1/s\n", state.certified_bound);
  if (std::isnan(state.rising))
    out +=
        "whether some perturbation grows by itself is not known: of so large a spectrum the stiff end alone "
        "is "
        "found\n";
  if (state.rising > 0)
    out += fmt::format("some perturbation grows by itself, by {:.3g} 1/s: it is left out like slow modes\n",
                       state.rising);
  return out + state_table(state, color) + "\n";
}

std::string states_section(const StabilityResults& results, bool color) {
  std::string out =
      "The scene frozen at states of a run: f = J (y - y*). Predicted from eigenvalues; measured: the "
      "longest "
      "step without\ngrowth, of every mode where all eigenvalues are known, else from the stiffest mode and "
      "white noise; slow modes\nare left out. They agree within 2 %; within 1e-4 of 1 growth can not be told "
      "apart. A complex spectrum predicts\nforward Euler's limit alone.\n\n";
  for (const auto& state : results.states) out += state_section(state, color);
  for (const auto& note : results.notes) out += "note: " + note + "\n";
  return out;
}

/// Words of `text` in lines of a readable width, each indented.
std::string wrapped(const std::string& text) {
  constexpr std::size_t width = 112;
  std::string out, line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > width)
      out += fmt::format("    {}\n", std::exchange(line, {}));
    line += (line.empty() ? "" : " ") + word;
  }
  return out + fmt::format("    {}\n", line);
}

Style style_of(Verdict::Grade grade) {
  switch (grade) {
    case Verdict::Grade::safe:
      return Style::green;
    case Verdict::Grade::careful:
      return Style::yellow;
    case Verdict::Grade::unsafe:
      return Style::red;
  }
  return Style::plain;
}

std::string verdicts_section(const StabilityResults& results, bool color) {
  std::string out;
  for (const auto& verdict : results.verdicts)
    out +=
        fmt::format("{}: {}\n{}", styled(verdict.method, Style::bold, color),
                    styled(grade_name(verdict.grade), style_of(verdict.grade), color), wrapped(verdict.text));
  return out;
}

}  // namespace

std::string stability_text(const StabilityResults& results, bool color) {
  std::string out =
      styled(results.case_name + (results.title.empty() ? "" : ": " + results.title), Style::bold, color);
  out += fmt::format("\n{}, lambda_max = {:.6g} 1/s (residual {:.1e})\n",
                     quantity(results.unknowns, "unknown"), results.lambda_max, results.lambda_residual);
  if (results.linear) {
    out += heading("Stability functions: theory and measurement", color) + methods_section(results, color);
    out += heading("Critical step of forward Euler", color) +
           critical_step_section(results.critical_step, color);
  }
  out += heading("Limits at frozen states", color) + states_section(results, color);
  out += heading("Rounding growth inside supersteps", color) + rounding_section(results, color);
  out += heading("Bounds and overshoot over random networks", color) + sweeps_section(results.sweeps, color);
  out += heading("Verdicts", color) + verdicts_section(results, color);
  return out;
}

}  // namespace superstep
