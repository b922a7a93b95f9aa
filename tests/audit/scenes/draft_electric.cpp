#include <algorithm>
#include <cmath>

#include "audit/scenes/calibration.hpp"
#include "audit/scenes/draft.hpp"
#include "audit/scenes/excursion.hpp"
#include "core/index.hpp"

namespace superstep::audit {
namespace {

std::int32_t free_node_of_first_piece(Draft& draft, const Graph& graph) {
  auto node = draft.any_node();
  while (graph.is_fixed[at(node)] || draft.wiring.component[at(node)] != 0)
    node = (node + 1) % draft.wiring.nodes;
  return node;
}

void hold(Draft& draft, std::int32_t node, double value, Graph& graph) {
  graph.is_fixed[at(node)] = 1;
  graph.fixed_value[at(node)] = value;
  if (value == 0 || draft.constant || draft.chance(0.4)) return;
  if (graph.fixed_table.empty()) graph.fixed_table.assign(graph.nodes(), -1);
  const bool from_zero = draft.chance(0.7);
  graph.fixed_table[at(node)] = add_table(draft, from_zero ? 0 : value, from_zero ? value : 0, graph);
}

/// Largest magnitude that the inputs of a graph take, node by node.
struct Peaks {
  std::vector<double> fixed, source;
};

Peaks peaks(const Graph& graph) {
  Peaks peaks{graph.fixed_value, graph.source};
  const auto largest = [&](std::int32_t table) {
    double peak = 0;
    for (const double value : graph.tables[at(table)].value)
      if (std::abs(value) > std::abs(peak)) peak = value;
    return peak;
  };
  for (std::size_t node = 0; node < graph.fixed_table.size(); ++node)
    if (graph.fixed_table[node] >= 0) peaks.fixed[node] = largest(graph.fixed_table[node]);
  for (const auto& source : graph.tabled_sources) peaks.source[at(source.node)] += largest(source.table);
  return peaks;
}

void multiply_inputs(double factor, Graph& graph) {
  for (auto& value : graph.fixed_value) value *= factor;
  for (auto& value : graph.source) value *= factor;
  for (auto& value : graph.initial) value *= factor;
  for (auto& table : graph.tables)
    for (auto& value : table.value) value *= factor;
  for (std::size_t node = 0; node < graph.fixed_table.size(); ++node)
    if (graph.fixed_table[node] >= 0)
      graph.fixed_value[node] = graph.tables[at(graph.fixed_table[node])].at(0);
}

}  // namespace

FieldScene bare_electric(Draft& draft, const Graph& thermal, bool vary, bool steady) {
  FieldScene field;
  field.name = "potential";
  field.unit = "V";
  field.steady = steady;
  field.laws = random_laws(draft, vary);
  // Like the necks of a packing: where heat passes easily, current does.
  field.graph = bare_graph(draft, log_uniform(draft.random, 1, 100), log_uniform(draft.random, 1, 10));
  double largest = 0;
  for (const double conductance : thermal.conductance) largest = std::max(largest, conductance);
  for (std::size_t e = 0; e < thermal.edges(); ++e)
    field.graph.conductance[e] *= std::sqrt(thermal.conductance[e] / largest);
  field.bare = field.graph.conductance;
  return field;
}

void draw_electric_inputs(Draft& draft, const Graph& thermal, FieldScene& electric) {
  Graph& graph = electric.graph;
  hold(draft, free_node_of_first_piece(draft, graph), 0, graph);
  const bool current = draft.chance(0.2);
  const auto feeder = free_node_of_first_piece(draft, graph);
  if (!current) {
    hold(draft, feeder, draft.random.uniform(0.5, 1), graph);
    const bool third = draft.chance(0.3) && draft.wiring.nodes >= 12;  // the first piece has a third of them
    if (third) hold(draft, free_node_of_first_piece(draft, graph), draft.random.uniform(), graph);
  } else if (draft.constant || draft.chance(0.5)) {
    graph.source[at(feeder)] = 1;
  } else {
    graph.tabled_sources.push_back({feeder, add_table(draft, 0, 1, graph)});
  }
  if (!electric.steady && draft.chance(0.15))
    for (auto& value : graph.initial) value = draft.random.uniform();
  // A current of 1 A is replaced by one that causes some 1 V, so that starts and currents have one size.
  if (current) {
    const double conductance = *std::max_element(graph.conductance.begin(), graph.conductance.end());
    for (auto& value : graph.source) value *= 1e-2 * conductance;
    for (const auto& source : graph.tabled_sources)
      for (auto& value : graph.tables[at(source.table)].value) value *= 1e-2 * conductance;
  }
  const Peaks peak = peaks(graph);
  const auto heat = steady_joule_heat(graph, electric.laws, peak.fixed, peak.source);
  const double rise = rise_of(thermal, heat, draft.scene.t_end);
  double factor = rise > 0 ? std::sqrt(draft.joule_rise / rise) : 1;
  if (!electric.steady) {
    // Charging the capacities heats as well: half C V^2 of a node must not be more than its share of the
    // rise.
    double ratio = 0;
    for (std::size_t node = 0; node < graph.nodes(); ++node)
      ratio = std::max(ratio, graph.capacity[node] / thermal.capacity[node]);
    factor = std::min(factor, std::sqrt(draft.joule_rise / ratio));
  }
  multiply_inputs(factor, graph);
}

}  // namespace superstep::audit
