#include <algorithm>
#include <cmath>

#include "audit/scenes/draft.hpp"
#include "audit/scenes/excursion.hpp"
#include "core/index.hpp"

namespace superstep::audit {
namespace {

/// Conductances within `contrast`: spread evenly over its decades, or of two sorts.
double draw_conductance(Random& random, bool two_sorts, double contrast) {
  if (!two_sorts) return log_uniform(random, 1, contrast);
  const double sort = random.uniform() < 0.3 ? 1 : contrast;
  return sort * random.uniform(0.5, 2);
}

std::vector<double> node_conductance(const Graph& graph) {
  std::vector<double> sum(graph.nodes(), 0.0);
  double mean = 0;
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    sum[at(graph.i[e])] += graph.conductance[e];
    sum[at(graph.j[e])] += graph.conductance[e];
    mean += graph.conductance[e] / static_cast<double>(graph.edges());
  }
  for (auto& value : sum)
    if (value == 0) value = mean;
  return sum;
}

/// Nodes 0 .. n-1, each with probability `share`, at least one.
std::vector<std::int32_t> some_nodes(Draft& draft, double share) {
  std::vector<std::int32_t> chosen;
  for (std::int32_t node = 0; node < draft.wiring.nodes; ++node)
    if (draft.chance(share)) chosen.push_back(node);
  if (chosen.empty()) chosen.push_back(draft.any_node());
  return chosen;
}

/// kappa from `a` to `b` times the reference between two temperatures.
ConductivityLaw line(double value, double low, double high, double a, double b) {
  ConductivityLaw law{.kind = ConductivityLaw::Kind::linear, .value = value};
  law.coefficient = (b - a) / (high - low);
  law.reference = low + (1 - a) / (b - a) * (high - low);
  return law;
}

ConductivityLaw random_law(Draft& draft) {
  Random& random = draft.random;
  const double value = log_uniform(random, 1, 10), low = draft.offset, high = draft.highest();
  const auto kind = random.below(3);
  if (kind == 0) {
    const double a = random.uniform(0.4, 1.5), step = random.uniform(0.3, 1);
    return line(value, low, high, a, draft.chance(0.5) || a - step < 0.3 ? a + step : a - step);
  }
  if (kind == 1) {
    ConductivityLaw law{.kind = ConductivityLaw::Kind::table};
    const auto points = 3 + random.below(4);
    const double margin = 0.3 * (high - low);
    for (std::size_t k = 0; k < points; ++k) {
      const double part = static_cast<double>(k) / static_cast<double>(points - 1);
      const double moved = k == 0 || k + 1 == points ? 0 : random.uniform(-0.3, 0.3);
      law.temperatures.push_back(low - margin +
                                 (part + moved / static_cast<double>(points)) * (high - low + 2 * margin));
      law.values.push_back(value * random.uniform(0.4, 2));
    }
    law.value = law.values.front();
    return law;
  }
  ConductivityLaw law{.kind = ConductivityLaw::Kind::sigmoid, .value = value};
  law.amplitude = draft.chance(0.3) ? random.uniform(-0.6, -0.1) : random.uniform(0.1, 3);
  law.reference = low + random.uniform(-0.2, 1.2) * (high - low);
  law.steepness = log_uniform(random, 1, 30) / (high - low);
  return law;
}

}  // namespace

Graph bare_graph(Draft& draft, double contrast, double spread) {
  Random& random = draft.random;
  const auto nodes = static_cast<std::size_t>(draft.wiring.nodes);
  const double conductance_unit = log_uniform(random, 1e-4, 1e2);
  const double capacity_unit = log_uniform(random, 1e-6, 1e2);
  const bool two_sorts = draft.chance(0.3);
  Graph graph;
  graph.i = draft.wiring.i;
  graph.j = draft.wiring.j;
  for (std::size_t e = 0; e < graph.i.size(); ++e)
    graph.conductance.push_back(conductance_unit * draw_conductance(random, two_sorts, contrast));
  if (graph.edges() > 8 && draft.chance(0.05)) graph.conductance.back() = 0;
  for (std::size_t node = 0; node < nodes; ++node) {
    graph.id.push_back(static_cast<std::int64_t>(node));
    graph.capacity.push_back(capacity_unit * log_uniform(random, 1, spread));
  }
  graph.source.assign(nodes, 0.0);
  graph.initial.assign(nodes, 0.0);
  graph.fixed_value.assign(nodes, 0.0);
  graph.is_fixed.assign(nodes, 0);
  return graph;
}

ConductionLaws random_laws(Draft& draft, bool vary) {
  ConductionLaws laws;
  const auto materials = 1 + draft.random.below(3);
  const auto varying = draft.random.below(materials);  // at least this one does
  for (std::size_t k = 0; k < materials; ++k) {
    if (vary && (k == varying || draft.chance(0.7)))
      laws.of_material.push_back(random_law(draft));
    else
      laws.of_material.push_back({.value = log_uniform(draft.random, 1, 10)});
  }
  for (std::int32_t node = 0; node < draft.wiring.nodes; ++node)
    laws.material.push_back(static_cast<std::int32_t>(draft.random.below(materials)));
  laws.material[0] = static_cast<std::int32_t>(varying);
  laws.mean = draft.chance(0.5) ? ConductanceMean::harmonic : ConductanceMean::arithmetic;
  return laws;
}

void add_convection(Draft& draft, Graph& graph) {
  const auto conductance = node_conductance(graph);
  const double strength = log_uniform(draft.random, 1e-4, 10);
  const double share = draft.chance(0.5) ? 1 : 0.3, ambient = draft.level();
  for (const auto node : some_nodes(draft, share))
    graph.convection.push_back({node, strength * conductance[at(node)], ambient, -1});
}

void add_radiation(Draft& draft, Graph& graph) {
  const auto conductance = node_conductance(graph);
  const double hot = draft.offset + draft.scale, strength = log_uniform(draft.random, 1e-3, 10);
  const double share = draft.chance(0.5) ? 1 : 0.3;
  const double ambient = draft.chance(0.4) ? hot : draft.level();
  for (const auto node : some_nodes(draft, share))
    graph.radiation.push_back({node, strength * conductance[at(node)] / (4 * hot * hot * hot), ambient, -1});
}

}  // namespace superstep::audit
