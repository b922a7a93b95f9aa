#include "case/build_rhs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "case/checks/field_at_state.hpp"
#include "case/checks/skips.hpp"
#include "case/roles.hpp"
#include "core/error.hpp"
#include "core/index.hpp"
#include "core/text/quantity.hpp"
#include "network/network_in_order.hpp"
#include "network/spd_solver.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep {
namespace {

/// Null where there is none.
template <class SceneOrConst>
auto* find_field(SceneOrConst& scene, const char* name) {
  const auto found = std::find_if(scene.fields.begin(), scene.fields.end(),
                                  [&](const FieldScene& field) { return field.name == name; });
  return found == scene.fields.end() ? nullptr : &*found;
}

bool varies(const FieldScene& field) {
  return std::any_of(field.laws.of_material.begin(), field.laws.of_material.end(),
                     [](const auto& law) { return law.varies(); });
}

/// Rows that stand in the order of the nodes are all free ones: who has a part of them cannot know in which
/// clusters nothing happens, and rows would be others.
void integrate_idle_clusters(const FieldScene& field, RoleReport& report) {
  std::replace(report.roles.begin(), report.roles.end(), NodeRole::idle, NodeRole::free);
  for (const auto& eliminated : field.algebraic) report.roles[at(eliminated.node)] = NodeRole::idle;
  report.floating += std::exchange(report.idle_clusters, 0);
}

std::vector<char> apply_roles(RoleReport report, FieldScene& field) {
  if (field.in_order && !field.steady) integrate_idle_clusters(field, report);
  field.roles = std::move(report.roles);
  field.components = report.components;
  field.idle_clusters = report.idle_clusters;
  field.floating_clusters = report.floating;
  field.adrift_clusters = report.adrift;
  return std::move(report.live);
}

/// Range of everything that the field starts from, or is held at up to t_end. Where a node of capacity 0
/// starts says nothing: it takes the value that its neighbours give it.
void set_range(double t_end, FieldScene& field) {
  std::vector<char> follows(field.graph.nodes(), 0);
  for (const auto& algebraic : field.algebraic) follows[at(algebraic.node)] = 1;
  bool first = true;
  const auto take = [&](double value) {
    field.low = first ? value : std::min(field.low, value);
    field.high = first ? value : std::max(field.high, value);
    first = false;
  };
  const auto take_table = [&](std::int32_t index) {
    const auto [low, high] = field.graph.tables[at(index)].range(0, t_end);
    take(low);
    take(high);
  };
  const auto& graph = field.graph;
  for (std::size_t node = 0; node < graph.nodes(); ++node) {
    if (follows[node]) continue;
    if (!graph.is_fixed[node])
      take(graph.initial[node]);
    else if (graph.fixed_table.empty() || graph.fixed_table[node] < 0)
      take(graph.fixed_value[node]);
    else
      take_table(graph.fixed_table[node]);
  }
}

void set_origin(FieldScene& field) {
  if (field.graph.radiation.empty()) field.origin = origin_of(field.low, field.high);
}

/// Values of the nodes that are not rows of the network.
std::vector<KnownValue> known_values(const FieldScene& field) {
  std::vector<KnownValue> known;
  const auto& graph = field.graph;
  for (std::size_t node = 0; node < graph.nodes(); ++node) {
    if (field.row_of_node[node] >= 0) continue;
    const bool fixed = graph.is_fixed[node] != 0;
    known.push_back({static_cast<std::int32_t>(node), fixed ? graph.fixed_at(node, 0) : graph.initial[node],
                     fixed && !graph.fixed_table.empty() ? graph.fixed_table[node] : -1});
  }
  return known;
}

Network network_of(const FieldScene& field) {
  if (!field.in_order) return build_network(field.graph, field.roles, field.origin);
  std::vector<std::int32_t> order(field.graph.nodes());
  std::iota(order.begin(), order.end(), 0);
  return build_network_in_order(field.graph, field.roles, field.origin, order);
}

/// Of the particles alone, at the temperatures that the scene starts from.
double pair_step(const Scene& scene, const FieldScene& field) {
  const auto bare = field.bare_conductance();
  const FieldScene* thermal = find_field(scene, "temperature");
  if (!varies(field) || !thermal) return min_pair_step(field.graph, field.roles, bare);
  const Graph& graph = thermal->graph;
  std::vector<double> conductance(bare.begin(), bare.end()), temperature = graph.initial;
  for (std::size_t node = 0; node < temperature.size(); ++node)
    if (graph.is_fixed[node]) temperature[node] = graph.fixed_at(node, 0);
  scale_conductances(field, conductivities_at(field, temperature), conductance);
  return min_pair_step(field.graph, field.roles, conductance);
}

FieldInput field_input(const Scene& scene, const FieldScene& field, Network network) {
  FieldInput input;
  input.network = std::move(network);
  input.pair_step = pair_step(scene, field);
  input.known = known_values(field);
  input.laws = field.laws;
  input.id = field.graph.id;
  input.low = field.low - field.origin;
  input.high = field.high - field.origin;
  return input;
}

/// Fixed values that follow a table and touch fixed nodes only: nothing of their own field feels them, but a
/// current through them heats, and conductivities follow them.
bool has_tables_apart(const FieldInput& field) {
  std::vector<std::int32_t> touching = field.network.ghost_node;
  std::sort(touching.begin(), touching.end());
  return std::any_of(field.known.begin(), field.known.end(), [&](const KnownValue& known) {
    return known.table >= 0 && !std::binary_search(touching.begin(), touching.end(), known.node);
  });
}

void mark_tables_apart(NonlinearInput& input) {
  if (!input.potential) return;
  for (auto* field : {&input.temperature, &*input.potential})
    field->network.tabled_apart = has_tables_apart(*field);
}

FieldInput take_field(const Scene& scene, FieldScene& field) {
  Network network = network_of(field);
  field.row_of_node = network.row_of_node;
  return field_input(scene, field, std::move(network));
}

void append_initial(const FieldScene& field, const Network& network, Scene& scene) {
  for (const auto node : network.node_of_row)
    scene.initial.push_back(field.graph.initial[at(node)] - field.origin);
}

void build_single(const std::string& where, FieldScene& field, Scene& scene) {
  apply_roles(assign_roles(field.graph, where, {}, field.algebraic), field);
  set_range(scene.t_end, field);
  field.view = 0;
  if (varies(field)) {
    NonlinearInput input;
    input.temperature = take_field(scene, field);
    append_initial(field, input.temperature.network, scene);
    scene.rhs = std::make_unique<NonlinearRhs>(std::move(input));
    return;
  }
  set_origin(field);
  Network network = network_of(field);
  field.row_of_node = network.row_of_node;
  append_initial(field, network, scene);
  scene.rhs =
      std::make_unique<NetworkRhs>(std::move(network), field.name, field.unit, pair_step(scene, field));
}

/// A steady potential that nothing moves heats like a constant source: one solve, and it is done with.
/// Source: Rojek & Nisar 2026, eq. 7.
void add_constant_joule_heat(const FieldScene& electric, const std::vector<double>& potential,
                             Graph& thermal) {
  const auto& graph = electric.graph;
  for (std::size_t k = 0; k < graph.edges(); ++k) {
    const auto i = at(graph.i[k]), j = at(graph.j[k]);
    const double dv = potential[j] - potential[i], heat = graph.conductance[k] * dv * dv;
    const double a = electric.laws.of_node(graph.i[k]).value, b = electric.laws.of_node(graph.j[k]).value;
    thermal.source[i] += heat * b / (a + b);
    thermal.source[j] += heat * a / (a + b);
  }
}

/// Solves for a potential that nothing moves.
void solve_once(FieldScene& electric, Scene& scene) {
  const FieldInput input = take_field(scene, electric);
  const auto rows = steady_state(input.network);
  scene.steady_potential.assign(electric.graph.nodes(), 0.0);
  for (const auto& known : input.known) scene.steady_potential[at(known.node)] = known.value;
  for (std::size_t row = 0; row < rows.size(); ++row)
    scene.steady_potential[at(input.network.node_of_row[row])] = rows[row];
}

void build_pair(const std::string& where, const Coupling& coupling, FieldScene& electric, FieldScene& thermal,
                Scene& scene) {
  auto live =
      apply_roles(electric.steady ? assign_steady_roles(electric.graph, where)
                                  : assign_roles(electric.graph, where + ": [electric] mode = \"transient\""),
                  electric);
  if (!coupling.joule_heat) live.assign(live.size(), 0);
  set_range(scene.t_end, electric);
  if (electric.steady && !varies(electric) && electric.graph.tables.empty()) {
    solve_once(electric, scene);
    if (coupling.joule_heat) add_constant_joule_heat(electric, scene.steady_potential, thermal.graph);
    build_single(where, thermal, scene);
    return;
  }
  apply_roles(assign_roles(thermal.graph, where + ": [thermal]", live), thermal);
  set_range(scene.t_end, thermal);
  if (!varies(electric) && !varies(thermal)) set_origin(thermal);
  NonlinearInput input;
  input.temperature = take_field(scene, thermal);
  input.potential = take_field(scene, electric);
  mark_tables_apart(input);
  input.steady_potential = electric.steady;
  input.resolve_change = coupling.resolve_change;
  scene.settle_tolerance = electric.steady ? 0 : coupling.settle_tolerance;
  if (coupling.joule_heat) input.joule = &electric.graph;
  thermal.view = electric.steady ? 0 : 1;
  if (!electric.steady) {
    electric.view = 0;
    append_initial(electric, input.potential->network, scene);
  }
  append_initial(thermal, input.temperature.network, scene);
  auto rhs = std::make_unique<NonlinearRhs>(std::move(input));
  if (electric.steady) scene.moving_potential = rhs.get();
  scene.rhs = std::move(rhs);
}

/// A steady potential alone: solved for here, and nothing is left to integrate.
void build_steady(const std::string& where, FieldScene& electric, Scene& scene) {
  apply_roles(assign_steady_roles(electric.graph, where), electric);
  set_range(scene.t_end, electric);
  solve_once(electric, scene);
  Network nothing;
  nothing.row_begin.assign(1, 0);
  scene.rhs = std::make_unique<NetworkRhs>(std::move(nothing), electric.name, electric.unit,
                                           pair_step(scene, electric));
}

void list_field_skips(const FieldScene& field, bool only, Scene& scene) {
  const auto count = [&](NodeRole role) { return std::count(field.roles.begin(), field.roles.end(), role); };
  const std::string of_field = only ? "" : fmt::format(" of the {}", field.name);
  const auto nodes_in = [&](std::size_t nodes, std::size_t clusters) {
    return fmt::format("{} in {}{}", quantity(nodes, "node"), quantity(clusters, "cluster"), of_field);
  };
  if (const auto fixed = count(NodeRole::fixed); fixed > 0)
    scene.skips.push_back(fixed_nodes_skip(fixed, of_field));
  const auto algebraic = field.algebraic.size();
  if (algebraic > 0)
    scene.skips.push_back({fmt::format("{} of capacity 0{}", quantity(algebraic, "node"), of_field),
                           algebraic == 1
                               ? "it is eliminated: its value follows from its neighbours"
                               : "they are eliminated: their values follow from their neighbours"});
  if (field.idle_clusters > 0)
    scene.skips.push_back(
        {nodes_in(static_cast<std::size_t>(count(NodeRole::idle)) - algebraic, field.idle_clusters),
         "values there are uniform and nothing acts on them"});
  if (field.steady && field.floating_clusters > 0)
    scene.skips.push_back({nodes_in(static_cast<std::size_t>(count(NodeRole::idle)), field.floating_clusters),
                           "without an electrode no current flows there"});
}

void list_term_skips(const FieldScene& field, Scene& scene) {
  if (field.name != "temperature") return;
  if (field.graph.convection.empty()) scene.skips.push_back(convection_skip());
  if (field.graph.radiation.empty()) scene.skips.push_back(radiation_skip());
}

const char* why_not_stepped(const FieldScene& steady, const Scene& scene) {
  if (!scene.moving_potential) return "it is steady and nothing moves it: solved for once";
  return varies(steady) ? "it is steady: solved for when conductivities have moved"
                        : "it is steady: solved for once for each of its inputs";
}

void list_skips(Scene& scene) {
  const FieldScene* electric = find_field(scene, "potential");
  const FieldScene* thermal = find_field(scene, "temperature");
  for (const auto& field : scene.fields) list_field_skips(field, scene.fields.size() == 1, scene);
  if (scene.fields.front().in_order) scene.skips.push_back(order_skip(scene.packed.has_value()));
  if (!electric) scene.skips.push_back(electric_skip());
  if (!thermal) scene.skips.push_back(thermal_skip());
  if (!scene.packed) {
    scene.skips.push_back(search_skip());
    return;
  }
  for (const auto& field : scene.fields) list_term_skips(field, scene);
  if (electric && electric->steady)
    scene.skips.push_back({"stepping the potential", why_not_stepped(*electric, scene)});
}

}  // namespace

double origin_of(double low, double high) noexcept {
  return low > 0 ? low : std::min(high, 0.0);
}

NonlinearInput nonlinear_input(const Scene& scene) {
  NonlinearInput input;
  for (const auto& field : scene.fields) {
    if (field.view < 0) continue;
    FieldInput one = field_input(scene, field, network_of(field));
    if (field.name == "potential") {
      input.potential = std::move(one);
      if (dynamic_cast<const NonlinearRhs&>(*scene.rhs).heats()) input.joule = &field.graph;
    } else {
      input.temperature = std::move(one);
    }
  }
  mark_tables_apart(input);
  return input;
}

void build_rhs(const std::string& where, const Coupling& coupling, Scene& scene) {
  FieldScene* electric = find_field(scene, "potential");
  FieldScene* thermal = find_field(scene, "temperature");
  if (electric && thermal)
    build_pair(where, coupling, *electric, *thermal, scene);
  else if (electric && electric->steady)
    build_steady(where, *electric, scene);
  else
    build_single(where, scene.fields.front(), scene);
  list_skips(scene);
}

}  // namespace superstep
