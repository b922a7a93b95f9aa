/// The library as somebody else uses it: a case file, one integrator, and the final temperatures.

#include <case/scene.hpp>
#include <integrators/registry.hpp>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const superstep::Scene scene = superstep::load_scene(argv[1]);
  const auto method = superstep::make_integrator(argv[2]);
  superstep::Plan plan;
  plan.output_times = scene.output_times;
  plan.ranges = {scene.fields.front().range_of_state()};
  method->prepare(*scene.rhs, plan);
  method->start(0.0, scene.initial);
  for (const double t : scene.output_times)
    if (const auto outcome = method->advance(t); !outcome.ok())
      return (std::cerr << outcome.reason << '\n', 1);
  for (const double value : scene.values_on_nodes(0, method->time(), method->state()))
    std::cout << value << '\n';
}
