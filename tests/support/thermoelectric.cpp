#include "support/thermoelectric.hpp"

#include "support/problem.hpp"

namespace superstep::test {
namespace {

double mean_of(ConductanceMean mean, double a, double b) {
  return mean == ConductanceMean::harmonic ? 2 * a * b / (a + b) : (a + b) / 2;
}

/// Conductances = a geometry in [1, 5] times the mean of the laws' reference values.
void scale_conductances(const std::vector<ConductivityLaw>& laws, ConductanceMean mean, Graph& graph) {
  for (std::size_t k = 0; k < graph.edges(); ++k)
    graph.conductance[k] *= mean_of(mean, laws[static_cast<std::size_t>(graph.i[k]) % 2].value,
                                    laws[static_cast<std::size_t>(graph.j[k]) % 2].value);
}

ConductionLaws laws_of(const std::vector<ConductivityLaw>& laws, ConductanceMean mean, std::size_t nodes) {
  ConductionLaws out{laws, {}, mean};
  for (std::size_t node = 0; node < nodes; ++node)
    out.material.push_back(static_cast<std::int32_t>(node % 2));
  return out;
}

FieldInput input_of(const Graph& graph, ConductionLaws laws) {
  FieldInput input;
  const auto roles = plain_roles(graph);
  input.network = build_network(graph, roles);
  input.pair_step = min_pair_step(graph, roles, graph.conductance);
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (graph.is_fixed[node])
      input.known.push_back({static_cast<std::int32_t>(node), graph.fixed_at(node, 0),
                             graph.fixed_table.empty() ? -1 : graph.fixed_table[node]});
  input.laws = std::move(laws);
  input.high = 1;
  return input;
}

}  // namespace

Graph Thermoelectric::thermal_graph() const {
  Graph graph = random_graph({.nodes = nodes, .seed = 5, .contrast = 5, .fixed = 0});
  graph.initial.assign(nodes, 0.0);
  scale_conductances(thermal, mean, graph);
  if (tables) graph.tables.push_back({{0, 1}, {0.2, 0.9}});
  if (convection)
    for (std::int32_t node = 0; node < 4; ++node)
      graph.convection.push_back({node, 0.3, 0.4, tables ? 0 : -1});
  if (radiation)
    for (std::int32_t node = 2; node < 7; ++node) graph.radiation.push_back({node, 0.2, 0.8, -1});
  return graph;
}

Graph Thermoelectric::electric_graph() const {
  Graph graph = random_graph({.nodes = nodes, .seed = 5, .contrast = 5, .fixed = 2});
  scale_conductances(electric, mean, graph);
  for (double& capacity : graph.capacity) capacity *= 0.3;
  graph.initial.assign(nodes, 0.0);
  const bool own = !electrode.time.empty();
  if (!tables && !own) return graph;
  graph.tables.push_back(own ? electrode : TimeTable{{0, 1}, {0.5, 1.0}});
  graph.fixed_table.assign(nodes, -1);
  for (std::size_t node = 0; node < nodes; ++node)
    if (graph.is_fixed[node] && graph.fixed_value[node] == 1) graph.fixed_table[node] = 0;
  return graph;
}

Network Thermoelectric::electric_network() const {
  const Graph graph = electric_graph();
  return build_network(graph, plain_roles(graph));
}

std::unique_ptr<NonlinearRhs> Thermoelectric::build() const {
  NonlinearInput input;
  input.temperature = input_of(thermal_graph(), laws_of(thermal, mean, nodes));
  if (!potential) return std::make_unique<NonlinearRhs>(std::move(input));
  const Graph graph = electric_graph();
  input.potential = input_of(graph, laws_of(electric, mean, nodes));
  input.steady_potential = steady;
  if (joule_heat) input.joule = &graph;
  return std::make_unique<NonlinearRhs>(std::move(input));
}

CoupledRun run_coupled(Rhs& rhs, const std::string& spec, const std::vector<double>& times,
                       FieldRange temperature, double settle_tolerance) {
  CoupledRun out;
  out.history = ProbeHistory(1);
  Plan plan;
  plan.output_times = times;
  for (const auto& field : rhs.fields())
    plan.ranges.push_back(field.name == "potential" ? FieldRange{0, 1} : temperature);
  plan.probes = {rhs.size() - 1};
  plan.history = &out.history;
  plan.track_inflow = true;
  plan.settle_tolerance = settle_tolerance;
  const auto method = make_integrator(spec);
  const std::vector<double> initial(rhs.size(), 0.0);
  try {
    method->prepare(rhs, plan);
    method->start(0, initial);
    for (const double t : times) {
      out.outcome = method->advance(t);
      if (!out.outcome.ok()) return out;
      out.states.emplace_back(method->state().begin(), method->state().end());
    }
  } catch (const Refused& refused) {
    out.outcome = {Status::refused, refused.what()};
  }
  out.statistics = method->statistics();
  out.settled_at = method->settled_at();
  return out;
}

}  // namespace superstep::test
