#include "scene/roles.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "network/components.hpp"

namespace superstep {
namespace {

struct ComponentFacts {
  bool seen = false, uniform = true, sourced = false, has_fixed = false, has_free = false;
  double value = 0;
  [[nodiscard]] bool idle() const noexcept { return uniform && !sourced && has_free; }
};

std::vector<ComponentFacts> examine(const Graph& graph, const Components& components) {
  std::vector<ComponentFacts> facts(components.count);
  for (std::size_t node = 0; node < graph.nodes(); ++node) {
    auto& fact = facts[static_cast<std::size_t>(components.of_node[node])];
    const bool fixed = graph.is_fixed[node] != 0;
    const double value = fixed ? graph.fixed_value[node] : graph.initial[node];
    if (fact.seen && value != fact.value) fact.uniform = false;
    fact.seen = true;
    fact.value = value;
    fact.sourced = fact.sourced || (!fixed && graph.source[node] != 0);
    (fixed ? fact.has_fixed : fact.has_free) = true;
  }
  return facts;
}

}  // namespace

RoleReport assign_roles(const Graph& graph, const std::string& where) {
  const Components components = connected_components(graph.nodes(), graph.i, graph.j, graph.conductance);
  const auto facts = examine(graph, components);
  const bool something_moves =
      std::any_of(facts.begin(), facts.end(), [](const auto& fact) { return fact.has_free && !fact.idle(); });
  RoleReport report;
  report.components = components.count;
  for (const auto& fact : facts) {
    if (something_moves && fact.idle())
      ++report.idle_clusters;
    else if (fact.has_free && !fact.has_fixed)
      ++report.floating;
  }
  report.roles.resize(graph.nodes());
  bool any_free = false;
  for (std::size_t node = 0; node < graph.nodes(); ++node) {
    const bool idle = something_moves && facts[static_cast<std::size_t>(components.of_node[node])].idle();
    report.roles[node] = graph.is_fixed[node] != 0 ? NodeRole::fixed : idle ? NodeRole::idle : NodeRole::free;
    any_free = any_free || report.roles[node] == NodeRole::free;
  }
  if (!any_free)
    throw InputError(
        fmt::format("{}: every node is fixed, so nothing is left to integrate; free some", where));
  return report;
}

}  // namespace superstep
