/// Sweep variants: kernels of every instruction set, the reference, Eigen's product and update, and the
/// triad.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>

#include "bench/micro/networks.hpp"
#include "core/stopwatch.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep::micro {
namespace {

struct Sample {
  explicit Sample(const Rows& r) : rows(r), sell(sliced(rows)), eigen(eigen_matrix(rows)) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      y1.push_back(300 + static_cast<double>(i % 7));
      y2.push_back(300 + static_cast<double>(i % 5));
    }
    out = y1;
  }
  /// What must pass between memory and processor: each entry and index once, two vectors in, one out.
  [[nodiscard]] double bytes() const {
    return 12.0 * static_cast<double>(sell.entries()) + 24.0 * static_cast<double>(rows.size());
  }
  /// A Chebyshev stage: y1, y2 -> out.
  [[nodiscard]] Stage stage() const {
    return {.y1 = y1.data(), .a = 1.2, .d = 1e-12, .y2 = y2.data(), .b = -0.2};
  }

  Rows rows;
  SlicedRows sell;
  EigenMatrix eigen;
  std::vector<double> y1, y2, out;
};

const Network& network_of(const Scene& scene) {
  return dynamic_cast<const NetworkRhs&>(*scene.rhs).network();
}

Sample& sample(const std::string& name) {
  static std::map<std::string, Sample> all;
  if (const auto known = all.find(name); known != all.end()) return known->second;
  const auto make = [&]() -> Sample {
    const auto& nial = nial_thermal();
    if (name == "nial") return Sample(ordered_rows(network_of(nial)));
    if (name == "nial_file_order")
      return Sample(rows_in_file_order(nial.fields.front().graph, network_of(nial)));
    const Graph graph = lattice_graph(100);
    const Network network = build_network(graph, std::vector<NodeRole>(graph.nodes(), NodeRole::free));
    return Sample(name == "million" ? ordered_rows(network) : rows_in_file_order(graph, network));
  };
  return all.emplace(name, make()).first->second;
}

/// Bytes per second of the triad, measured once in this process.
double triad_rate() {
  static const double rate = [] {
    Triad arrays;
    std::vector<double> seconds;
    for (int k = 0; k < 15; ++k) {
      const double start = process_cpu_seconds();
      arrays.run();
      seconds.push_back(process_cpu_seconds() - start);
    }
    std::nth_element(seconds.begin(), seconds.begin() + 7, seconds.end());
    return arrays.bytes() / seconds[7];
  }();
  return rate;
}

void count(benchmark::State& state, const Sample& on) {
  state.counters["s_per_nonzero"] =
      benchmark::Counter(static_cast<double>(on.rows.nonzeros()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["B_per_s"] = benchmark::Counter(on.bytes(), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["of_triad"] =
      benchmark::Counter(on.bytes() / triad_rate(), benchmark::Counter::kIsIterationInvariantRate);
}

void register_sample(const std::string& name) {
  const auto add = [&](const std::string& kind, const std::function<void(Sample&)>& work) {
    benchmark::RegisterBenchmark(fmt::format("sweep/{}/{}", name, kind).c_str(),
                                 [name, work](benchmark::State& state) {
                                   Sample& on = sample(name);
                                   for (auto _ : state) {
                                     work(on);
                                     benchmark::ClobberMemory();
                                   }
                                   count(state, on);
                                 });
  };
  for (const auto& kernel : sweep_kernels())
    add(fmt::format("sell8-{}", kernel.name), [sweep = kernel.sweep](Sample& on) {
      sweep(on.sell, on.stage(), 0, on.sell.slices(), on.out.data());
    });
  add("reference", [](Sample& on) { reference_sweep(on.rows.view(), on.stage(), on.out.data()); });
  add("eigen", [](Sample& on) {
    const auto n = static_cast<Eigen::Index>(on.rows.size());
    const Eigen::Map<const Eigen::VectorXd> y1(on.y1.data(), n), y2(on.y2.data(), n);
    Eigen::Map<Eigen::VectorXd> out(on.out.data(), n);
    out.noalias() = on.eigen * y1;
    out = 1.2 * y1 - 0.2 * y2 + 1e-12 * out;
  });
}

/// What the path from an integrator through Rhs to the kernel costs on top of the kernel.
void erased_call(benchmark::State& state) {
  Graph graph = lattice_graph(2);
  NetworkRhs rhs(build_network(graph, std::vector<NodeRole>(graph.nodes(), NodeRole::free)), "temperature",
                 "K", 1.0);
  std::vector<double> y(rhs.size(), 1.0), out(rhs.size());
  Rhs& erased = rhs;
  for (auto _ : state) {
    erased.stage(0, {.y1 = y.data(), .a = 1, .d = 1e-3}, out);
    benchmark::ClobberMemory();
  }
}
void direct_call(benchmark::State& state) {
  Graph graph = lattice_graph(2);
  const auto rows = ordered_rows(build_network(graph, std::vector<NodeRole>(graph.nodes(), NodeRole::free)));
  const auto sell = sliced(rows);
  std::vector<double> y(rows.size(), 1.0), out(rows.size());
  for (auto _ : state) {
    fused_sweep(sell, {.y1 = y.data(), .a = 1, .d = 1e-3}, out.data());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(erased_call)->Name("call/eight_nodes/through_rhs");
BENCHMARK(direct_call)->Name("call/eight_nodes/kernel");

void triad(benchmark::State& state) {
  Triad arrays;
  for (auto _ : state) {
    arrays.run();
    benchmark::ClobberMemory();
  }
  state.counters["B_per_s"] =
      benchmark::Counter(arrays.bytes(), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(triad)->Name("triad");

const bool sweeps_registered = [] {
  omp_set_num_threads(1);  // Eigen and the triad would take all, and their CPU time is that of one
  for (const char* name : {"nial", "nial_file_order", "million", "million_file_order"}) register_sample(name);
  return true;
}();

}  // namespace
}  // namespace superstep::micro
