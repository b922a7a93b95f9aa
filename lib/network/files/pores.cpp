#include "network/files/pores.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"

namespace superstep {

std::string with_dots(std::string name) {
  for (const std::string bar : {" | ", "|"})
    for (std::size_t at = name.find(bar); at != std::string::npos; at = name.find(bar, at))
      name.replace(at, bar.size(), ".");
  return name;
}

std::optional<std::size_t> find_name(std::span<const std::string> names, const std::string& wanted,
                                     const std::string& where) {
  const std::string end = with_dots(wanted);
  std::optional<std::size_t> found;
  std::string meant;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string name = with_dots(names[k]);
    if (name == end) return k;
    if (!name.ends_with("." + end) && !name.ends_with(" " + end)) continue;
    meant += (found ? ", " : "") + names[k];
    found = found ? names.size() : k;
  }
  if (found == names.size())
    throw InputError(
        fmt::format("{}: several are called '{}': {}; give the whole name of one", where, wanted, meant));
  return found;
}

void join_pores(const std::string& file, std::span<const Pore> pores, std::span<const Throat> throats,
                PoreNetwork& network) {
  const auto place = [&](std::size_t line, const char* what, std::size_t k) {
    return line > 0 ? fmt::format("{}:{}", file, line) : fmt::format("{}: {} {}", file, what, k);
  };
  if (pores.empty()) throw InputError(fmt::format("{}: has no pores; at least one is needed", file));
  Graph& graph = network.input.graph;
  graph = equal_nodes(pores.size());
  for (std::size_t k = 0; k < pores.size(); ++k) {
    graph.capacity[k] = pores[k].capacity;
    if (!(pores[k].capacity >= 0) || std::isinf(pores[k].capacity))
      throw InputError(fmt::format("{}: the capacity is {}; it must be finite and >= 0",
                                   place(pores[k].line, "pore", k), pores[k].capacity));
  }
  const auto count = static_cast<std::int64_t>(pores.size());
  for (std::size_t k = 0; k < throats.size(); ++k) {
    const auto& throat = throats[k];
    const auto here = [&] { return place(throat.line, "throat", k); };
    if (throat.i >= count || throat.j >= count || throat.i == throat.j)
      throw InputError(fmt::format("{}: throat joins pores {} and {}; they must be two of the {} pores",
                                   here(), throat.i, throat.j, count));
    if (!(throat.conductance >= 0) || std::isinf(throat.conductance))
      throw InputError(
          fmt::format("{}: the conductance is {}; it must be finite and >= 0", here(), throat.conductance));
    add_edge(graph, static_cast<std::size_t>(throat.i), static_cast<std::size_t>(throat.j),
             throat.conductance);
  }
  if (const auto joined = join_parallel_edges(graph); joined > 0)
    network.input.notes.push_back(fmt::format(
        "{}: {} throats run parallel to others, and their conductances are summed", file, joined));
}

}  // namespace superstep
