#include "case/checks/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/text/quantity.hpp"

namespace superstep {
namespace {

void warn_outside(std::vector<std::string>& out, const char* what, double smallest, double largest,
                  double low, double high, const char* unit) {
  const auto say = [&](const char* which, double value) {
    out.push_back(fmt::format("{} {} is {:.4g}{}{}; usual values lie between {:g} and {:g}", which, what,
                              value, *unit ? " " : "", unit, low, high));
  };
  if (smallest < low) say("smallest", smallest);
  if (largest > high) say("largest", largest);
}

/// A table of time of which the run sees one value: times of another origin, or in another unit.
void warn_of_times(const FieldScene& field, double t_end, std::vector<std::string>& out) {
  for (const auto& table : field.graph.tables) {
    const bool is_late = table.time.front() > t_end, is_early = table.time.back() <= 0;
    if (!(is_late || is_early) || table.lowest() == table.highest()) continue;
    out.push_back(fmt::format(
        "a table of time of the {} holds from {:.10g} to {:.10g} s, and the run goes from 0 to {:.10g} s: "
        "nothing in it changes, it stays at {:.6g}; are its times counted from the start of the run, in s?",
        field.name, table.time.front(), table.time.back(), t_end,
        is_late ? table.value.front() : table.value.back()));
  }
}

}  // namespace

void add_warnings(const std::vector<std::string>& more, std::vector<std::string>& all) {
  for (const auto& one : more)
    if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

std::vector<std::string> packing_warnings(const PackingFacts& facts) {
  std::vector<std::string> out;
  warn_outside(out, "diameter", 2 * facts.smallest_radius, 2 * facts.largest_radius, 1e-7, 0.1,
               "m (is length_unit right?)");
  const double coordination = 2 * static_cast<double>(facts.contacts) / static_cast<double>(facts.particles);
  constexpr std::size_t few = 100;
  if (facts.particles > few) warn_outside(out, "mean coordination", coordination, coordination, 3, 12, "");
  if (facts.limited_necks > 0)
    out.push_back(fmt::format("{} of {} limited to the smaller radius", facts.limited_necks,
                              quantity(facts.contacts, "neck was", "necks were")));
  return out;
}

std::vector<std::string> range_warnings(const Scene& scene) {
  std::vector<std::string> out;
  if (scene.packed) {
    const auto& packed = *scene.packed;
    const auto [smallest, largest] =
        std::minmax_element(packed.packing.radius.begin(), packed.packing.radius.end());
    out = packing_warnings({.smallest_radius = *smallest,
                            .largest_radius = *largest,
                            .particles = packed.packing.size(),
                            .contacts = packed.contacts.size(),
                            .limited_necks = packed.neck_report.limited});
  }
  if (scene.rhs && !scene.output_times.empty()) {
    constexpr double many = 1e14;  // the roundings of so many exchanges are a per cent
    const double exchanges = scene.output_times.back() * scene.rhs->spectral_bound(0, scene.initial);
    if (exchanges > many)
      out.push_back(
          fmt::format("t_end is {:.2g} times as long as the fastest exchange takes; roundings may hide "
                      "what is slow: look at the answer with --verify",
                      exchanges));
  }
  for (const auto& field : scene.fields) warn_of_times(field, scene.t_end, out);
  for (const auto& field : scene.fields)
    if (field.adrift_clusters > 0 && !field.steady)
      out.push_back(fmt::format("{} without a fixed {} {}; what enters {} stays",
                                quantity(field.adrift_clusters, "cluster"), field.name,
                                field.adrift_clusters == 1 ? "is integrated" : "are integrated",
                                field.adrift_clusters == 1 ? "it" : "them"));
  return out;
}

std::string implausible_sizes(const Scene& scene) {
  constexpr double smallest = 1e-8, largest = 1;         // m
  constexpr double usual_low = 1e-6, usual_high = 1e-2;  // m
  if (!scene.packed) return {};
  std::vector<double> radii = scene.packed->packing.radius;
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  const double median = 2 * *middle;
  if (median >= smallest && median <= largest) return {};
  std::string likely;
  for (const auto& [name, unit] : {std::pair{"m", 1.0}, {"mm", 1e-3}, {"um", 1e-6}}) {
    const double other = median / scene.packed->length_unit * unit;
    if (likely.empty() && other >= usual_low && other <= usual_high)
      likely = fmt::format("; length_unit = \"{}\" would make it {:.3g} m", name, other);
  }
  return fmt::format("{}: the median diameter of the particles is {:.3g} m{}", scene.file, median, likely);
}

std::vector<std::string> material_warnings(const FieldKind& kind, const FieldMaterials& field,
                                           const Materials& materials) {
  std::vector<std::string> out;
  const bool thermal = kind.name == "temperature";
  const auto warn = [&](const char* what, double value, double low, double high, const char* unit) {
    warn_outside(out, what, value, value, low, high, unit);
  };
  for (std::size_t k = 0; k < field.of_material.size(); ++k) {
    warn("density", materials.density(static_cast<std::int32_t>(k)), 500, 2e4, "kg/m3");
    if (thermal) {
      warn("specific heat", field.of_material[k].capacity, 100, 5000, "J/(kg K)");
      warn("thermal conductivity", field.of_material[k].conductivity.value, 0.02, 400, "W/(m K)");
    } else {
      warn("electric conductivity", field.of_material[k].conductivity.value, 1e-12, 6e7, "S/m");
    }
  }
  const auto warn_interface = [&](const Interface& interface) {
    if (!(interface.thickness > 0)) return;
    warn("grain boundary thickness", interface.thickness, 1e-9, 1e-6, "m");
    warn("grain boundary reduction", interface.reduction, 0.01, 1, "");
  };
  warn_interface(field.grain_boundary);
  for (const auto& [pair, interface] : field.between) warn_interface(interface);
  return out;
}

}  // namespace superstep
