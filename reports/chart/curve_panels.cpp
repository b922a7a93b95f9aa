#include "reports/chart/curve_panels.hpp"

#include <algorithm>

#include "core/text/options.hpp"

namespace superstep {
namespace {

constexpr std::size_t few = 5;

std::string setting(const Spec& spec, const std::string& key) {
  for (const auto& [name, value] : spec.settings)
    if (name == key) return value;
  return {};
}

std::string method_panel(const std::string& text, const std::string& sts_key) {
  try {
    const Spec spec = parse_spec(text);
    const std::string value = setting(spec, sts_key);
    if (spec.name != "sts" || value.empty()) return spec.name;
    return sts_key == "nu" ? "STS, ν = " + value : "STS, N = " + value;
  } catch (const std::exception&) {  // not a SPEC: its text names it
    return text;
  }
}

std::string place_of(const ProbeCurve& curve) {
  return curve.field + " at " + curve.probe;
}

}  // namespace

std::vector<CurvePanel> curve_panels(const std::vector<ProbeCurve>& curves, const std::string& sts_key) {
  std::vector<std::string> specs;
  for (const auto& curve : curves) specs.push_back(curve.spec);
  const auto looks = looks_of(specs);
  std::vector<CurvePanel> panels;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const std::string place = place_of(curves[k]);
    const auto of_place = std::count_if(curves.begin(), curves.end(),
                                        [&](const auto& other) { return place_of(other) == place; });
    const bool together = static_cast<std::size_t>(of_place) <= few;
    const std::string title = together ? place : place + ": " + method_panel(curves[k].spec, sts_key);
    auto panel =
        std::find_if(panels.begin(), panels.end(), [&](const auto& one) { return one.title == title; });
    if (panel == panels.end()) panel = panels.insert(panels.end(), CurvePanel{.title = title, .curves = {}});
    panel->curves.push_back({&curves[k], looks[k]});
  }
  return panels;
}

}  // namespace superstep
