#include "case/checks/effective.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "core/error.hpp"
#include "network/cell_problem.hpp"
#include "network/components.hpp"
#include "network/spd_solver.hpp"

namespace superstep {
namespace {

/// Roles for a steady solve: whatever touches no fixed node has no steady state of its own and is left out.
std::vector<NodeRole> steady_roles(const Graph& graph) {
  const Components components = connected_components(graph.nodes(), graph.i, graph.j, graph.conductance);
  std::vector<char> held(components.count, 0);
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (graph.is_fixed[node]) held[static_cast<std::size_t>(components.of_node[node])] = 1;
  std::vector<NodeRole> roles(graph.nodes());
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    roles[node] = graph.is_fixed[node]                                            ? NodeRole::fixed
                  : held[static_cast<std::size_t>(components.of_node[node])] != 0 ? NodeRole::free
                                                                                  : NodeRole::idle;
  return roles;
}

/// Flow out of the nodes held at `high` [W or A].
double flow_from(const Graph& graph, const std::vector<double>& value, double high) {
  double flow = 0;
  for (std::size_t k = 0; k < graph.edges(); ++k) {
    const auto i = static_cast<std::size_t>(graph.i[k]), j = static_cast<std::size_t>(graph.j[k]);
    const bool from_i = graph.is_fixed[i] && graph.fixed_value[i] == high;
    const bool from_j = graph.is_fixed[j] && graph.fixed_value[j] == high;
    if (from_i != from_j) flow += graph.conductance[k] * (from_i ? value[i] - value[j] : value[j] - value[i]);
  }
  return flow;
}

double coordinate(Vec3 v, int axis) noexcept {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double x) noexcept {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// Largest gap along any axis between the centres of the two layers [m], with its axis.
std::pair<double, int> facing_gap(const Packing& packing, const Graph& graph, double high) {
  std::pair<double, int> best{0, 2};
  for (int axis = 0; axis < 3; ++axis) {
    Extent hot, cold;
    for (std::size_t node = 0; node < graph.nodes(); ++node)
      if (graph.is_fixed[node])
        (graph.fixed_value[node] == high ? hot : cold).add(coordinate(packing.centre[node], axis));
    const double gap = std::max(hot.low - cold.high, cold.low - hot.high);
    if (gap > best.first) best = {gap, axis};
  }
  return best;
}

/// Cross-section of the packing's surfaces; along periodic edges, of the cell.
double box_area(const Packing& packing, int axis) {
  const Bounds box = surface_bounds(packing);
  Vec3 size = box.max - box.min;
  if (packing.cell) {
    const auto& cell = *packing.cell;
    const auto one = static_cast<std::size_t>((axis + 1) % 3),
               other = static_cast<std::size_t>((axis + 2) % 3);
    if (cell.periodic[one] && cell.periodic[other]) return norm(cross(cell.edge[one], cell.edge[other]));
    if (cell.periodic[0]) size.x = cell.height(0);
    if (cell.periodic[1]) size.y = cell.height(1);
    if (cell.periodic[2]) size.z = cell.height(2);
  }
  const std::array<double, 3> area = {size.y * size.z, size.x * size.z, size.x * size.y};
  return area[static_cast<std::size_t>(axis)];
}

/// What `box_area` has taken.
std::string box_words(const Packing& packing, int axis) {
  int joined = 0;
  for (int other = 0; other < 3; ++other)
    if (other != axis && packing.cell && packing.cell->periodic[static_cast<std::size_t>(other)]) ++joined;
  return joined == 2 ? "the periodic cell"
         : joined == 1
             ? "the periodic cell along one side, of the bounding box of all surfaces along the other"
             : "the bounding box of all surfaces";
}

/// Steady values on all nodes, of fixed values and sources alone. Throws NumericalError.
std::vector<double> steady_values(const Graph& graph, const std::vector<NodeRole>& roles) {
  Graph bare = graph;
  bare.convection.clear();
  bare.radiation.clear();
  const Network network = build_network(bare, roles);
  const auto solution = steady_state(network);
  std::vector<double> value(graph.nodes(), 0.0);
  for (std::size_t node = 0; node < graph.nodes(); ++node) {
    const auto row = network.row_of_node[node];
    value[node] = graph.is_fixed[node] ? graph.fixed_value[node]
                  : row >= 0           ? solution[static_cast<std::size_t>(row)]
                                       : graph.initial[node];
  }
  return value;
}

/// True where contacts lead from a node held at `low` to one held at `high`.
bool are_joined(const Graph& graph, double low, double high) {
  const Components components = connected_components(graph.nodes(), graph.i, graph.j, graph.conductance);
  std::vector<char> has_low(components.count, 0), has_high(components.count, 0);
  for (std::size_t node = 0; node < graph.nodes(); ++node) {
    if (!graph.is_fixed[node]) continue;
    const auto component = static_cast<std::size_t>(components.of_node[node]);
    if (graph.fixed_value[node] == low) has_low[component] = 1;
    if (graph.fixed_value[node] == high) has_high[component] = 1;
  }
  for (std::size_t k = 0; k < components.count; ++k)
    if (has_low[k] != 0 && has_high[k] != 0) return true;
  return false;
}

bool is_periodic_along(const Packing& packing, int axis) noexcept {
  return packing.cell && packing.cell->periodic[static_cast<std::size_t>(axis)];
}

/// Leaves out the contacts that lead across the side of the cell.
void cut_across(const Contacts& contacts, int axis, Graph& graph) {
  for (std::size_t k = 0; k < contacts.image.size(); ++k)
    if (contacts.image[k][static_cast<std::size_t>(axis)] != 0) graph.conductance[k] = 0;
}

/// Nothing where a sphere may touch its own image, which the contacts of a scene leave out.
std::optional<double> under_mean_gradient(const PackingScene& packed, const Graph& graph, int axis) {
  const auto& packing = packed.packing;
  const auto k = static_cast<std::size_t>(axis);
  const double largest = 2 * *std::max_element(packing.radius.begin(), packing.radius.end());
  for (std::size_t edge = 0; edge < 3; ++edge)
    if (packing.cell->periodic[edge] && packing.cell->height(edge) < 1.5 * largest) return std::nullopt;
  try {
    return periodic_conductivity(packing, packed.contacts, graph.conductance)[k][k];
  } catch (const NumericalError&) {
    return std::nullopt;
  }
}

std::set<double> fixed_levels(const Graph& graph) {
  std::set<double> levels;
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (graph.is_fixed[node]) levels.insert(graph.fixed_value[node]);
  return levels;
}

}  // namespace

std::optional<ElectrodeFacts> electrode_facts(const FieldScene& field, const FieldAtState& state) {
  const auto& graph = state.graph;
  const auto levels = fixed_levels(graph);
  if (field.name != "potential" || levels.size() != 2) return std::nullopt;
  // What they are fed leaves in part through held nodes, and heats: neither is in the graph without them.
  const bool hidden =
      std::any_of(field.algebraic.begin(), field.algebraic.end(),
                  [](const AlgebraicNode& node) { return node.constant != 0 || !node.tabled.empty(); });
  if (hidden) return std::nullopt;
  const double low = *levels.begin(), high = *levels.rbegin();
  try {
    const auto roles = steady_roles(graph);
    const auto value = steady_values(graph, roles);
    const bool fed = state.has_sources();
    const bool flows = fed || are_joined(graph, low, high);
    ElectrodeFacts facts{.voltage = high - low,
                         .current_in = flows ? flow_from(graph, value, high) : 0,
                         .current_out = flows ? -flow_from(graph, value, low) : 0,
                         .resistance = std::nullopt};
    if (!fed)
      facts.resistance =
          facts.current_in > 0 ? facts.voltage / facts.current_in : std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < graph.edges(); ++k) {
      const auto i = static_cast<std::size_t>(graph.i[k]), j = static_cast<std::size_t>(graph.j[k]);
      if (roles[i] == NodeRole::idle) continue;  // and its neighbour is, too: they have no steady state
      const double dv = value[j] - value[i];
      facts.joule_heat += graph.conductance[k] * dv * dv;
    }
    return facts;
  } catch (const NumericalError&) {
    return std::nullopt;
  }
}

EffectiveConductivity effective_conductivity(const Scene& scene, const FieldScene& field) {
  return effective_conductivity(scene, field_at_start(scene, field));
}

EffectiveConductivity effective_conductivity(const Scene& scene, const FieldAtState& state) {
  EffectiveConductivity out;
  Graph graph = state.graph;
  const auto levels = fixed_levels(graph);
  if (!scene.packed)
    out.note = "a network without coordinates has no cross-section";
  else if (levels.size() != 2)
    out.note = "it needs two layers with two different fixed values";
  else if (state.has_sources())
    out.note = "sources feed particles, so that what enters at one layer is not what leaves at the other";
  if (!out.note.empty()) return out;

  const double low = *levels.begin(), high = *levels.rbegin();
  const auto& packing = scene.packed->packing;
  const auto [gap, axis] = facing_gap(packing, graph, high);
  const bool faces = gap > 0, repeats = faces && is_periodic_along(packing, axis);
  if (repeats) {
    out.periodic = under_mean_gradient(*scene.packed, graph, axis);
    cut_across(scene.packed->contacts, axis, graph);
  }
  if (!are_joined(graph, low, high)) {
    out.value = 0;
    out.note =
        "no path of contacts from side to side; is length_unit right, or should [contact] gap join particles "
        "that nearly touch?";
    return out;
  }
  if (!faces) {
    out.note = "the two fixed layers do not face each other along an axis";
    return out;
  }
  try {
    const auto value = steady_values(graph, steady_roles(graph));
    out.flow = flow_from(graph, value, high);
  } catch (const NumericalError& error) {
    out.note = error.what();
    return out;
  }
  const bool stated = scene.packed->container && axis == 2;
  out.length = gap;
  out.area = stated ? scene.packed->container->cross_section : box_area(packing, axis);
  out.basis = fmt::format(
      "over {:.4g} m along {}, from centre to centre of the innermost particles held; cross-section {:.4g} "
      "m2 of {}",
      gap, "xyz"[axis], out.area, stated ? "the stated container" : box_words(packing, axis));
  const bool walled = !packing.cell || !packing.cell->is_periodic();
  if (!stated && walled) out.advice = "state [packing] container for a cylinder";
  out.value = out.flow * gap / (out.area * (high - low));
  return out;
}

}  // namespace superstep
