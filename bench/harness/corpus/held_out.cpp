#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "bench/harness/corpus/cost_fit.hpp"

namespace superstep {
namespace {

/// Straight lines between the points of a ladder, in logarithms; its ends beyond them.
std::optional<double> between(std::vector<std::pair<double, double>> points, double rtol) {
  if (points.empty()) return std::nullopt;
  std::sort(points.begin(), points.end());
  if (rtol <= points.front().first) return points.front().second;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const auto& [left, low] = points[k - 1];
    const auto& [right, high] = points[k];
    if (rtol > right) continue;
    const double part = std::log(rtol / left) / std::log(right / left);
    return low > 0 && high > 0 ? low * std::pow(high / low, part) : low + part * (high - low);
  }
  return points.back().second;
}

/// One scene at one tolerance, with constants that do not know its class.
HeldOut held_out(const SceneRows& scene, std::span<const CostPoint> points, double rtol,
                 const CostConstants& constants) {
  HeldOut out{
      .facts = scene.facts, .rtol = rtol, .choice = {}, .spec = {}, .cpu = {}, .error = {}, .best = {}};
  const Work work = work_of(*scene.facts);
  out.choice = candidates(work, rtol, constants).front();
  const std::string spec = family_spec(out.choice.family, work.physics);
  out.spec =
      fmt::format("{}{}rtol={:.1e}", spec, spec.find(':') == std::string::npos ? ":" : ",", out.choice.rtol);
  std::vector<std::pair<double, double>> cpu, error;
  for (const auto& point : points) {
    if (point.row->scene != scene.facts->scene || point.family != out.choice.family) continue;
    cpu.emplace_back(point.rtol, point.seconds);
    if (point.row->error) error.emplace_back(point.rtol, *point.row->error);
  }
  const bool reaches = std::any_of(cpu.begin(), cpu.end(), [&](const auto& one) {
    constexpr double a_rung = 100;  // a ladder that ends earlier did not end well further down
    return one.first <= a_rung * out.choice.rtol;
  });
  if (reaches) out.cpu = between(cpu, out.choice.rtol), out.error = between(error, out.choice.rtol);
  out.best = cheapest_row(scene, rtol, [](const CorpusRow& one) { return one.integrator != "auto"; });
  return out;
}

}  // namespace

double HeldOut::ratio() const {
  return cpu && best ? *cpu / *best->cpu : std::numeric_limits<double>::infinity();
}

bool HeldOut::within(double limit) const {
  return cpu && best && close_to_best(*cpu, *best->cpu, limit);
}

std::vector<HeldOut> held_out_choices(std::span<const CorpusRow> rows, std::span<const CostPoint> points) {
  const auto scenes = scenes_of(rows);
  std::set<std::string> classes;
  for (const auto& scene : scenes) classes.insert(scene.facts->scene_class);
  std::vector<HeldOut> out;
  for (const auto& held : classes) {
    std::vector<CostPoint> others;
    std::copy_if(points.begin(), points.end(), std::back_inserter(others),
                 [&](const CostPoint& point) { return point.row->scene_class != held; });
    const CostConstants constants = fit_costs(others);
    for (const auto& scene : scenes) {
      if (scene.facts->scene_class != held || scene.facts->physics.empty()) continue;
      for (const double rtol : corpus_levels()) {
        const Number bar = scene.facts->reference_error;
        if (!bar || bars_that_count * *bar > rtol) continue;
        HeldOut one = held_out(scene, points, rtol, constants);
        if (one.best) out.push_back(std::move(one));
      }
    }
  }
  return out;
}

std::string constants_header(const CostConstants& constants, std::span<const std::string> origin) {
  std::string out =
      "#pragma once\n"
      "/// What methods cost: the constants that `auto` and `exponential` choose by, written by `superstep "
      "fit`.\n"
      "///\n";
  for (const auto& line : origin) out += "/// " + line + "\n";
  out +=
      "\n#include \"integrators/costs/constants.hpp\"\n\n"
      "namespace superstep::fitted {\n\n"
      "constexpr CostConstants constants() {\n"
      "  CostConstants c;\n";
  for (const auto& one : cost_constants())
    out += fmt::format("  // {}\n  c.{} = {:.3g};\n", one.meaning, one.name, constants.*one.value);
  out += "  return c;\n}\n\n}  // namespace superstep::fitted\n";
  return out;
}

}  // namespace superstep
