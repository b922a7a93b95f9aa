/// How a packing conducts, by way of the case that `superstep init` would write.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "bench/app/file_report.hpp"
#include "case/checks/effective.hpp"
#include "case/roles.hpp"
#include "case/scene.hpp"
#include "contact/conductance.hpp"
#include "contact/neck.hpp"
#include "contact/search.hpp"
#include "core/error.hpp"
#include "integrators/registry.hpp"
#include "network/cell_problem.hpp"
#include "network/components.hpp"

namespace superstep {
namespace {

/// Mean gradient along the axis, across the sides of the cell.
std::optional<double> under_mean_gradient(const Packing& packing, const StarterSettings& settings,
                                          char axis) {
  const auto k = static_cast<std::size_t>(axis - 'x');
  if (!packing.cell || !packing.cell->periodic[k]) return std::nullopt;
  Contacts contacts = find_contacts(packing, 0.0, true);
  (void)apply_neck_law(packing, *find_neck_law(settings.neck), {}, contacts);
  std::vector<double> conductance;
  for (const double neck : contacts.neck_radius)
    conductance.push_back(series_conductance(settings.conductivity, settings.conductivity, neck));
  return periodic_conductivity(packing, contacts, conductance)[k][k];
}

/// Time that heat needs over the length of the packing: length^2 over the diffusivity, or, where nothing
/// leads through, over the slowest particle.
double transit_time(const Scene& scene, char axis, std::optional<double> conductivity) {
  const auto& packing = scene.packed->packing;
  const auto& graph = scene.fields.front().graph;
  const Bounds box = surface_bounds(packing);
  const Vec3 size = box.max - box.min;
  const double length = component(size, axis), volume = size.x * size.y * size.z;
  double capacity = 0;
  for (const double one : graph.capacity) capacity += one;
  if (conductivity && *conductivity > 0 && volume > 0)
    return 0.5 * length * length * capacity / (volume * *conductivity);
  std::vector<double> sum(graph.nodes(), 0.0);
  for (std::size_t k = 0; k < graph.edges(); ++k)
    for (const auto node : {graph.i[k], graph.j[k]})
      sum[static_cast<std::size_t>(node)] += graph.conductance[k];
  double slowest = 0;
  for (std::size_t node = 0; node < sum.size(); ++node)
    if (sum[node] > 0) slowest = std::max(slowest, graph.capacity[node] / sum[node]);
  return slowest > 0 ? 10 * slowest : 1.0;
}

double two_digits(double value) {
  const double scale = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::stod(fmt::format("{:.1e}", std::round(value / scale) * scale));
}

/// What `auto` says about a run to `t_end` at its own tolerance.
std::string recommended(const Scene& scene, double t_end) {
  if (scene.rhs->size() == 0) return "none: every particle is held";
  Plan plan;
  plan.output_times = {t_end};
  for (const auto& field : scene.fields) plan.ranges.push_back(field.range_of_state());
  const auto integrator = make_integrator("auto");
  integrator->prepare(*scene.rhs, plan);
  return integrator->choice();
}

void describe_contacts(const Packing& packing, const Contacts& contacts, PackingConduction& out) {
  out.coordination = 2 * static_cast<double>(contacts.size()) / static_cast<double>(packing.size());
  const std::vector<double> joined(contacts.size(), 1.0);
  out.components = connected_components(packing.size(), contacts.i, contacts.j, joined).count;
  std::vector<char> touches(packing.size(), 0);
  for (std::size_t k = 0; k < contacts.size(); ++k)
    touches[static_cast<std::size_t>(contacts.i[k])] = touches[static_cast<std::size_t>(contacts.j[k])] = 1;
  out.isolated = static_cast<std::size_t>(std::count(touches.begin(), touches.end(), 0));
}

void describe_conduction(const Scene& scene, PackingConduction& out) {
  const auto effective = effective_conductivity(scene, scene.fields.front());
  out.between_layers = effective.value;
  out.note = effective.note;
  out.basis = effective.basis;
  out.length = effective.length;
  out.area = effective.area;
  out.passes = !effective.value || *effective.value > 0;
  out.time = two_digits(transit_time(scene, out.axis, out.between_layers));
  if (out.passes) out.method = recommended(scene, out.time);
}

}  // namespace

StarterSettings starter_settings(const Packing& packing, const FileOptions& options,
                                 const std::string& file) {
  StarterSettings settings{.file = file,
                           .axis = options.axis,
                           .length_unit = options.length_unit,
                           .units = options.reading.units,
                           .periodic = options.reading.periodic};
  if (!options.neck.empty()) settings.neck = options.neck;
  settings.axis = starter_axis(packing, settings);
  settings.given_conductivity = options.conductivity.has_value();
  settings.given_density = options.density.has_value();
  settings.given_specific_heat = options.specific_heat.has_value();
  settings.conductivity = options.conductivity.value_or(settings.conductivity);
  settings.density = options.density.value_or(settings.density);
  settings.specific_heat = options.specific_heat.value_or(settings.specific_heat);
  return settings;
}

PackingConduction assess_conduction(const Packing& packing, const std::string& file,
                                    StarterSettings settings) {
  settings.file = std::filesystem::absolute(file).string();
  PackingConduction out;
  out.axis = settings.axis;
  const Contacts contacts = find_contacts(packing);
  out.periodic = under_mean_gradient(packing, settings, settings.axis);
  try {
    const Scene scene = load_scene(TomlTable::parse_text(starter_case(packing, settings), file));
    const Contacts& joined = scene.packed->contacts;
    describe_contacts(packing, contacts.size() >= joined.size() ? contacts : joined, out);
    describe_conduction(scene, out);
  } catch (const NothingFree&) {
    describe_contacts(packing, contacts, out);
    out.note = "all particles touch an end, where they would be held: nothing lies between";
    out.passes = false;
    out.all_held = true;
  }
  return out;
}

}  // namespace superstep
