/// A code that moves its own particles, and leaves their temperatures to Superstep: contacts are handed in at
/// each step of its own. Built against the installed package; prints what it checks, and fails where it is
/// wrong.
///   host CASE SPEC

#include <case/scene.hpp>
#include <cmath>
#include <integrators/host/hosted_heat.hpp>
#include <integrators/registry.hpp>
#include <iostream>
#include <stdexcept>

using superstep::HostedHeat;

// Contacts that stand still: many steps of a host are the one run of a scene. Returns the largest difference
// [K].
double difference_to_one_scene(const superstep::Scene& scene, const std::string& spec) {
  const auto& graph = scene.fields.front().graph;
  HostedHeat heat(graph.capacity, graph.initial, spec);
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (graph.is_fixed[node]) heat.hold(node, graph.fixed_value[node]);
  heat.set_sources(graph.source);
  std::vector<HostedHeat::Contact> contacts;
  for (std::size_t k = 0; k < graph.edges(); ++k)
    contacts.push_back({graph.i[k], graph.j[k], graph.conductance[k]});
  const int steps = 20;
  for (int step = 0; step < steps; ++step) {
    heat.set_contacts(contacts);
    if (const auto outcome = heat.advance_temperatures(scene.t_end / steps); !outcome.ok())
      throw std::runtime_error(outcome.reason);
  }
  const auto method = superstep::make_integrator(spec);
  superstep::Plan plan;
  plan.output_times = {scene.t_end};
  plan.ranges = {scene.fields.front().range_of_state()};
  method->prepare(*scene.rhs, plan);
  method->start(0.0, scene.initial);
  if (const auto outcome = method->advance(scene.t_end); !outcome.ok())
    throw std::runtime_error(outcome.reason);
  const auto expected = scene.values_on_nodes(0, method->time(), method->state());
  double largest = 0;
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    largest = std::max(largest, std::abs(heat.temperatures()[node] - expected[node]));
  return largest;
}

// A row of grains that swings like a spring: neighbours touch while they are near, and conduct the better the
// deeper they touch. Nothing leaves the row; returns the part of its heat that was lost or gained all the
// same.
double heat_lost_by_a_moving_row(const std::string& spec) {
  const int grains = 50, steps = 100;
  const std::vector<double> capacities(grains, 0.1);  // J/K
  std::vector<double> temperatures(grains, 300.0);    // K
  temperatures.front() = 400.0;
  HostedHeat heat(capacities, temperatures, spec);
  const double before = heat.heat();
  for (int step = 0; step < steps; ++step) {
    std::vector<HostedHeat::Contact> contacts;
    for (int i = 0; i + 1 < grains; ++i)
      if (const double depth = std::sin(0.3 * step + 0.5 * i) + 0.5; depth > 0)
        contacts.push_back({i, i + 1, 0.8 * std::sqrt(depth)});  // W/K
    heat.set_contacts(contacts);
    if (const auto outcome = heat.advance_temperatures(0.05); !outcome.ok())
      throw std::runtime_error(outcome.reason);
  }
  if (!(heat.temperatures()[5] > 300.1)) throw std::runtime_error("no heat has come to the sixth grain");
  return std::abs(heat.heat() / before - 1);
}

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const double difference = difference_to_one_scene(superstep::load_scene(argv[1]), argv[2]);
  const double lost = heat_lost_by_a_moving_row(argv[2]);
  std::cout << "difference to one scene " << difference << " K, heat lost " << lost << '\n';
  // Twenty runs may err by their tolerance each, 1e-8 of 1 K; heat is lost to rounding alone.
  return difference < 20e-8 && lost < 1e-12 ? 0 : 1;
}
