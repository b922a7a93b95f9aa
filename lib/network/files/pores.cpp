#include "network/files/pores.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"

namespace superstep {

void join_pores(const std::string& file, std::span<const double> capacities, std::span<const Throat> throats,
                PoreNetwork& network) {
  if (capacities.empty()) throw InputError(fmt::format("{}: has no pores; at least one is needed", file));
  for (std::size_t k = 0; k < capacities.size(); ++k)
    if (!(capacities[k] >= 0) || std::isinf(capacities[k]))
      throw InputError(fmt::format("{}: the capacity of pore {} is {}; it must be finite and >= 0", file, k,
                                   capacities[k]));
  Graph& graph = network.input.graph;
  graph = equal_nodes(capacities.size());
  graph.capacity.assign(capacities.begin(), capacities.end());
  const auto pores = static_cast<std::int64_t>(capacities.size());
  for (std::size_t k = 0; k < throats.size(); ++k) {
    const auto& throat = throats[k];
    const auto place = [&] {
      return throat.line > 0 ? fmt::format("{}:{}", file, throat.line)
                             : fmt::format("{}: throat {}", file, k);
    };
    if (throat.i >= pores || throat.j >= pores || throat.i == throat.j)
      throw InputError(fmt::format("{}: throat joins pores {} and {}; they must be two of the {} pores",
                                   place(), throat.i, throat.j, pores));
    if (!(throat.conductance >= 0) || std::isinf(throat.conductance))
      throw InputError(
          fmt::format("{}: the conductance is {}; it must be finite and >= 0", place(), throat.conductance));
    add_edge(graph, static_cast<std::size_t>(throat.i), static_cast<std::size_t>(throat.j),
             throat.conductance);
  }
  if (const auto joined = join_parallel_edges(graph); joined > 0)
    network.input.notes.push_back(fmt::format(
        "{}: {} throats run parallel to others, and their conductances are summed", file, joined));
}

}  // namespace superstep
