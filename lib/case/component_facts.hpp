#pragma once
/// What decides whether anything can happen in a connected component of a field.

#include "network/graph.hpp"

namespace superstep {

struct ComponentFacts {
  bool seen = false, uniform = true, acted_on = false, sourced = false;
  bool has_fixed = false, has_free = false, exchanges = false, fixed_differ = false, follows_table = false;
  double value = 0, fixed_value = 0;

  /// All its values are equal, and nothing acts on it.
  [[nodiscard]] bool idle() const noexcept { return uniform && !acted_on && !sourced && has_free; }
  /// It is integrated, and nothing holds its mean.
  [[nodiscard]] bool floats() const noexcept { return has_free && !has_fixed; }

  void take_node(const Graph& graph, std::size_t node) {
    const bool fixed = graph.is_fixed[node] != 0;
    const double here = fixed ? graph.fixed_value[node] : graph.initial[node];
    if (seen && here != value) uniform = false;
    seen = true;
    value = here;
    const bool varies = fixed && !graph.fixed_table.empty() && graph.fixed_table[node] >= 0;
    follows_table = follows_table || varies;
    if (varies) uniform = false;
    if (fixed && has_fixed && (follows_table || here != fixed_value)) fixed_differ = true;
    if (fixed) fixed_value = here;
    sourced = sourced || (!fixed && graph.source[node] != 0);
    (fixed ? has_fixed : has_free) = true;
  }
  /// What is known of another part of the component.
  void take(const ComponentFacts& part) noexcept {
    if (!part.seen) return;
    if (!seen) {
      *this = part;
      return;
    }
    const bool others_fixed = has_fixed && part.has_fixed;
    follows_table = follows_table || part.follows_table;
    fixed_differ = fixed_differ || part.fixed_differ ||
                   (others_fixed && (follows_table || fixed_value != part.fixed_value));
    if (part.has_fixed) fixed_value = part.fixed_value;
    uniform = uniform && part.uniform && value == part.value;
    acted_on = acted_on || part.acted_on;
    sourced = sourced || part.sourced;
    has_fixed = has_fixed || part.has_fixed;
    has_free = has_free || part.has_free;
    exchanges = exchanges || part.exchanges;
  }
  /// An exchange of one of its nodes with an ambient, after all nodes were taken.
  template <class Ambient>
  void take_exchange(const Ambient& exchange) {
    exchanges = true;
    if (exchange.table >= 0 || exchange.ambient != value) acted_on = true;
  }
};

}  // namespace superstep
