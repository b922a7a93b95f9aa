#include "case/roles.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/component_facts.hpp"
#include "core/error.hpp"
#include "core/index.hpp"
#include "network/components.hpp"

namespace superstep {
namespace {

/// Components of the graph as stated: an eliminated node is joined with whatever its value follows.
Components stated_components(const Graph& graph, std::span<const AlgebraicNode> algebraic) {
  if (algebraic.empty()) return connected_components(graph.nodes(), graph.i, graph.j, graph.conductance);
  auto i = graph.i, j = graph.j;
  auto joins = graph.conductance;
  for (const auto& gone : algebraic)
    for (const auto& [other, weight] : gone.weight) {
      i.push_back(gone.node);
      j.push_back(other);
      joins.push_back(weight);
    }
  return connected_components(graph.nodes(), i, j, joins);
}

std::vector<char> marks_of(const Graph& graph, std::span<const AlgebraicNode> algebraic) {
  std::vector<char> marks(graph.nodes(), 0);
  for (const auto& gone : algebraic) marks[at(gone.node)] = 1;
  return marks;
}

void examine_values(const Graph& graph, const Components& components, std::span<const char> eliminated,
                    std::vector<ComponentFacts>& facts) {
  for (std::size_t node = 0; node < graph.nodes(); ++node) {
    if (eliminated[node]) continue;
    facts[at(components.of_node[node])].take_node(graph, node);
  }
}

std::vector<ComponentFacts> examine(const Graph& graph, const Components& components,
                                    std::span<const char> acted_on, std::span<const char> eliminated) {
  std::vector<ComponentFacts> facts(components.count);
  examine_values(graph, components, eliminated, facts);
  const auto fact_of = [&](std::int32_t node) -> ComponentFacts& {
    return facts[at(components.of_node[at(node)])];
  };
  for (const auto& source : graph.tabled_sources)
    if (!graph.is_fixed[at(source.node)]) fact_of(source.node).sourced = true;
  for (const auto* exchanges : {&graph.convection, &graph.radiation})
    for (const auto& exchange : *exchanges) fact_of(exchange.node).take_exchange(exchange);
  for (std::size_t node = 0; node < acted_on.size(); ++node)
    if (acted_on[node] && !graph.is_fixed[node]) facts[at(components.of_node[node])].acted_on = true;
  return facts;
}

}  // namespace

RoleReport assign_roles(const Graph& graph, const std::string& where, std::span<const char> acted_on,
                        std::span<const AlgebraicNode> algebraic) {
  const Components components = stated_components(graph, algebraic);
  const auto eliminated = marks_of(graph, algebraic);
  const auto facts = examine(graph, components, acted_on, eliminated);
  const bool something_moves =
      std::any_of(facts.begin(), facts.end(), [](const auto& fact) { return fact.has_free && !fact.idle(); });
  RoleReport report;
  report.components = components.count;
  for (const auto& fact : facts) {
    if (something_moves && fact.idle()) {
      ++report.idle_clusters;
    } else if (fact.floats()) {
      ++report.floating;
      if (!fact.exchanges) ++report.adrift;
    }
  }
  report.roles.resize(graph.nodes());
  report.live.resize(graph.nodes());
  bool any_free = false;
  for (std::size_t node = 0; node < graph.nodes(); ++node) {
    const auto& fact = facts[at(components.of_node[node])];
    const bool idle = eliminated[node] || (something_moves && fact.idle());
    report.roles[node] = graph.is_fixed[node] != 0 ? NodeRole::fixed : idle ? NodeRole::idle : NodeRole::free;
    report.live[node] = !fact.idle() && (!fact.uniform || fact.acted_on || fact.sourced);
    any_free = any_free || report.roles[node] == NodeRole::free;
  }
  if (!any_free)
    throw NothingFree(
        fmt::format("{}: every node is fixed, so nothing is left to integrate; free some", where));
  return report;
}

RoleReport assign_steady_roles(const Graph& graph, const std::string& where) {
  const Components components = connected_components(graph.nodes(), graph.i, graph.j, graph.conductance);
  const auto facts = examine(graph, components, {}, marks_of(graph, {}));
  bool joined = false;
  std::vector<double> levels;
  for (const auto& fact : facts) {
    if (fact.sourced && !fact.has_fixed)
      throw InputError(fmt::format(
          "{}: a current source feeds a cluster without a fixed potential, where no steady potential exists; "
          "fix a potential there, or remove the source",
          where));
    joined = joined || fact.fixed_differ || fact.sourced;
    if (fact.has_fixed) levels.push_back(fact.fixed_value);
  }
  if (levels.empty())
    throw InputError(fmt::format("{}: a steady field needs at least one fixed value", where));
  const bool differ = std::adjacent_find(levels.begin(), levels.end(), std::not_equal_to<>()) != levels.end();
  if (differ && !joined)
    throw InputError(
        fmt::format("{}: the electrodes share no cluster, so that no current can flow; connect them (a "
                    "contact law with larger necks, a denser packing), or select other electrodes",
                    where));
  RoleReport report;
  report.components = components.count;
  for (const auto& fact : facts)
    if (!fact.has_fixed) ++report.floating;
  for (std::size_t node = 0; node < graph.nodes(); ++node) {
    const auto& fact = facts[at(components.of_node[node])];
    report.roles.push_back(graph.is_fixed[node] ? NodeRole::fixed
                           : fact.has_fixed     ? NodeRole::free
                                                : NodeRole::idle);
    report.live.push_back(fact.has_fixed && (fact.fixed_differ || fact.sourced || !fact.uniform));
  }
  return report;
}

}  // namespace superstep
