#include <algorithm>

#include "audit/scenes/calibration.hpp"
#include "audit/scenes/draft.hpp"
#include "audit/scenes/excursion.hpp"
#include "core/index.hpp"

namespace superstep::audit {
namespace {

void draw_start(Draft& draft, double rest, Graph& graph) {
  if (draft.at_rest) {
    graph.initial.assign(graph.nodes(), rest);
    return;
  }
  const bool halves = draft.chance(0.4);
  const double hot = draft.level(), cold = draft.level();
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    graph.initial[node] = !halves ? draft.level() : 2 * node < graph.nodes() ? hot : cold;
}

/// Fixed values: constant, or leaving the rest value or another one in time.
void draw_fixed(Draft& draft, double rest, std::size_t count, Graph& graph) {
  for (std::size_t k = 0; k < count; ++k) {
    const auto node = at(draft.any_node());
    if (graph.is_fixed[node]) continue;
    const double first = draft.level(), second = draft.level();
    const bool tabled = !draft.constant && draft.chance(0.5), from_rest = draft.chance(0.6);
    graph.is_fixed[node] = 1;
    graph.fixed_value[node] = !tabled && from_rest && k > 0 ? rest : first;
    if (!tabled) continue;
    if (graph.fixed_table.empty()) graph.fixed_table.assign(graph.nodes(), -1);
    graph.fixed_table[node] = add_table(draft, from_rest ? rest : first, second, graph);
    graph.fixed_value[node] = graph.tables.back().at(0);
  }
}

/// All exchanges of a kind share an ambient, as in a case file.
void draw_ambient(Draft& draft, double rest, std::vector<AmbientExchange>& exchanges, Graph& graph) {
  if (exchanges.empty() || draft.constant || draft.chance(0.5)) return;
  const double base = draft.chance(0.5) ? rest : exchanges.front().ambient;
  const auto table = add_table(draft, base, draft.level(), graph);
  for (auto& exchange : exchanges) {
    exchange.table = table;
    exchange.ambient = graph.tables.back().at(0);
  }
}

void draw_source(Draft& draft, double rise, Graph& graph) {
  auto node = draft.any_node();
  while (graph.is_fixed[at(node)]) node = (node + 1) % draft.wiring.nodes;
  const bool tabled = !draft.constant && draft.chance(0.7), cools = draft.linear && draft.chance(0.2);
  double active = draft.scene.t_end;
  std::int32_t table = -1;
  if (tabled) {
    auto excursion = random_excursion(draft.random, active, draft.wishes.steps, draft.most_points);
    if (excursion.inside > 0) draft.moments.push_back(excursion.inside);
    active = std::max(excursion.active, 1e-6 * active);
    graph.tables.push_back(excursion.shape);
    table = static_cast<std::int32_t>(graph.tables.size()) - 1;
  }
  std::vector<double> heat(graph.nodes(), 0.0);
  heat[at(node)] = 1;
  const double strength = (cools ? -rise : rise) / rise_of(graph, heat, active);
  if (table < 0) {
    graph.source[at(node)] += strength;
    return;
  }
  for (auto& value : graph.tables.back().value) value *= strength;
  graph.tabled_sources.push_back({node, table});
}

bool something_happens(const Graph& graph) {
  if (!graph.tables.empty()) return true;
  double low = graph.initial[0], high = low;
  const auto take = [&](double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  };
  for (std::size_t node = 0; node < graph.nodes(); ++node) {
    take(graph.is_fixed[node] ? graph.fixed_value[node] : graph.initial[node]);
    if (graph.source[node] != 0) return true;
  }
  for (const auto* exchanges : {&graph.convection, &graph.radiation})
    for (const auto& exchange : *exchanges) take(exchange.ambient);
  return high > low;
}

}  // namespace

std::int32_t add_table(Draft& draft, double base, double peak, Graph& graph) {
  const auto excursion =
      random_excursion(draft.random, draft.scene.t_end, draft.wishes.steps, draft.most_points);
  if (excursion.inside > 0) draft.moments.push_back(excursion.inside);
  graph.tables.push_back(excursion.between(base, peak));
  return static_cast<std::int32_t>(graph.tables.size()) - 1;
}

void draw_inputs(Draft& draft, std::size_t fixed_nodes, FieldScene& field) {
  Graph& graph = field.graph;
  const double rest = draft.chance(0.5) ? draft.offset : draft.level();
  draw_start(draft, rest, graph);
  draw_fixed(draft, rest, fixed_nodes, graph);
  draw_ambient(draft, rest, graph.convection, graph);
  draw_ambient(draft, rest, graph.radiation, graph);
  const bool driven_by_joule = draft.joule_rise > 0;
  std::size_t sources = draft.source_rise > 0 ? 1 + draft.random.below(3) : 0;
  if (!draft.constant && !driven_by_joule && graph.tables.empty())
    sources = std::max<std::size_t>(sources, 1);
  if (sources > 0 && draft.source_rise == 0) draft.source_rise = draft.scale;
  for (std::size_t k = 0; k < sources; ++k)
    draw_source(draft, draft.source_rise / static_cast<double>(sources), graph);
  if (driven_by_joule || something_happens(graph)) return;
  draft.at_rest = false;
  draw_start(draft, rest, graph);
}

}  // namespace superstep::audit
