/// Neighbour search, node orderings, factorizations, and a short run of each integrator.

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "bench/measure/run_one.hpp"
#include "bench/micro/networks.hpp"
#include "contact/search.hpp"
#include "integrators/registry.hpp"
#include "network/spd_solver.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep::micro {
namespace {

void neighbour_search(benchmark::State& state) {
  const Packing packing = lattice_packing(static_cast<std::int32_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(find_contacts(packing));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(packing.size()));
}
BENCHMARK(neighbour_search)->Arg(22)->Arg(46)->Unit(benchmark::kMillisecond);

void network_of_graph(benchmark::State& state) {
  const Graph graph = lattice_graph(static_cast<std::int32_t>(state.range(0)));
  const std::vector<NodeRole> roles(graph.nodes(), NodeRole::free);
  for (auto _ : state) benchmark::DoNotOptimize(build_network(graph, roles));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(graph.nodes()));
}
BENCHMARK(network_of_graph)->Arg(22)->Arg(46)->Unit(benchmark::kMillisecond);

void cholesky(benchmark::State& state) {
  const auto& network = dynamic_cast<const NetworkRhs&>(*nial_thermal().rhs).network();
  for (auto _ : state) {
    SpdSolver solver(network);
    state.counters["fill"] = static_cast<double>(solver.fill());
  }
}
BENCHMARK(cholesky)->Name("factorize/nial/cholmod")->Unit(benchmark::kMillisecond);

/// A hundredth of the thermal case: what preparation, estimates and a few steps of a method cost.
void integrate(benchmark::State& state, const std::string& spec) {
  Scene scene = load_scene(SUPERSTEP_SOURCE_DIR "/cases/nial_thermal.toml");
  scene.t_end *= 0.01;
  scene.output_times = {scene.t_end};
  std::uint64_t sweeps = 0, steps = 0;
  for (auto _ : state) {
    const RunResult run = run_one(scene, spec, {});
    if (!run.outcome.ok()) return state.SkipWithError(run.outcome.reason.c_str());
    sweeps = run.sweeps;
    steps = run.statistics.steps;
  }
  state.counters["steps"] = static_cast<double>(steps);
  state.counters["sweeps"] = static_cast<double>(sweeps);
  state.counters["s_per_step"] =
      benchmark::Counter(static_cast<double>(steps),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

const bool scenes_registered = [] {
  std::vector<std::string> specs;
  for (const auto& entry : integrators()) specs.push_back(entry.name);
  for (const char* solver : {"klu,ordering=metis", "klu,ordering=amd", "cholmod", "pcg", "gmres"})
    specs.push_back(std::string("cvode:linsol=") + solver);
  for (const auto& spec : specs)
    benchmark::RegisterBenchmark(("integrate/nial/" + spec).c_str(), [spec](benchmark::State& state) {
      integrate(state, spec);
    })->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace superstep::micro
