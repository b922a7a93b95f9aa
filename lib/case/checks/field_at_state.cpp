#include "case/checks/field_at_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/index.hpp"

namespace superstep {
namespace {

/// Temperatures of all nodes; nothing where there is no such field.
std::vector<double> temperatures_of(const Scene& scene, double t, std::span<const double> state) {
  for (std::size_t f = 0; f < scene.fields.size(); ++f)
    if (scene.fields[f].name == "temperature") return scene.values_on_nodes(f, t, state);
  return {};
}

/// Puts numbers in the places of tables.
void freeze_inputs(Graph& graph, double t) {
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (graph.is_fixed[node]) graph.fixed_value[node] = graph.fixed_at(node, t);
  graph.fixed_table.clear();
  for (const auto& [node, table] : graph.tabled_sources)
    graph.source[at(node)] += graph.tables[at(table)].at(t);
  graph.tabled_sources.clear();
  for (auto* exchanges : {&graph.convection, &graph.radiation})
    for (auto& one : *exchanges)
      if (one.table >= 0) one.ambient = graph.tables[at(std::exchange(one.table, -1))].at(t);
  graph.tables.clear();
}

}  // namespace

bool FieldAtState::has_sources() const noexcept {
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (!graph.is_fixed[node] && graph.source[node] != 0) return true;
  return false;
}

std::vector<double> conductivities_at(const FieldScene& field, std::span<const double> temperature) {
  std::vector<double> out;
  for (std::size_t node = 0; node < field.graph.nodes(); ++node) {
    const ConductivityLaw& law = field.laws.of_node(static_cast<std::int32_t>(node));
    out.push_back(temperature.empty() ? law.value : law.at(temperature[node]));
  }
  return out;
}

void scale_conductances(const FieldScene& field, std::span<const double> conductivity,
                        std::span<double> conductance) {
  const auto& laws = field.laws;
  with_mean(laws.mean, [&](auto mean) {
    for (std::size_t k = 0; k < conductance.size(); ++k) {
      const auto i = field.graph.i[k], j = field.graph.j[k];
      conductance[k] *= mean.value(conductivity[at(i)], conductivity[at(j)]) /
                        mean.value(laws.of_node(i).value, laws.of_node(j).value);
    }
  });
}

FieldAtState field_at(const Scene& scene, const FieldScene& field, double t, std::span<const double> state) {
  FieldAtState out{.graph = field.graph, .bare = {}, .conductivity = {}, .temperatures = {}};
  freeze_inputs(out.graph, t);
  const auto bare = field.bare_conductance();
  out.bare.assign(bare.begin(), bare.end());
  const auto& laws = field.laws;
  if (laws.of_material.empty()) return out;
  const bool varies = std::any_of(laws.of_material.begin(), laws.of_material.end(),
                                  [](const auto& law) { return law.varies(); });
  const auto temperature = varies ? temperatures_of(scene, t, state) : std::vector<double>{};
  out.conductivity = conductivities_at(field, temperature);
  if (temperature.empty()) return out;
  scale_conductances(field, out.conductivity, out.graph.conductance);
  scale_conductances(field, out.conductivity, out.bare);
  const auto [coldest, hottest] = std::minmax_element(temperature.begin(), temperature.end());
  out.temperatures = *coldest == *hottest ? fmt::format("{:.6g} K", *coldest)
                                          : fmt::format("{:.6g} to {:.6g} K", *coldest, *hottest);
  return out;
}

FieldAtState field_at_start(const Scene& scene, const FieldScene& field) {
  return field_at(scene, field, 0, scene.initial);
}

}  // namespace superstep
