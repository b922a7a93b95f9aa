#include "network/cell_problem.hpp"

#include <optional>
#include <vector>

#include "core/index.hpp"
#include "network/components.hpp"
#include "network/graph.hpp"
#include "network/network.hpp"
#include "network/spd_solver.hpp"

namespace superstep {
namespace {

constexpr std::array<Vec3, 3> axes = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

/// The contacts as a graph. The part that repeats is known up to a constant in each component: one node of
/// each holds it.
struct Pinned {
  Graph graph;
  std::vector<NodeRole> roles;
};

Pinned pinned_graph(std::size_t nodes, const Contacts& contacts, std::span<const double> conductance) {
  Pinned out{equal_nodes(nodes), std::vector<NodeRole>(nodes, NodeRole::free)};
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (contacts.i[k] != contacts.j[k] && conductance[k] > 0)
      add_edge(out.graph, at(contacts.i[k]), at(contacts.j[k]), conductance[k]);
  const Components components = connected_components(nodes, out.graph.i, out.graph.j, out.graph.conductance);
  std::vector<char> is_held(components.count, 0);
  for (std::size_t node = 0; node < nodes; ++node) {
    if (is_held[at(components.of_node[node])]) continue;
    is_held[at(components.of_node[node])] = 1;
    out.roles[node] = NodeRole::fixed;
    out.graph.is_fixed[node] = 1;
  }
  return out;
}

using Edges = std::array<int, 3>;  // of the cell, whole

struct Step {
  std::size_t to;
  Edges across;
};

std::vector<std::vector<Step>> steps_from_each(std::size_t nodes, const Contacts& contacts,
                                               std::span<const double> conductance) {
  std::vector<std::vector<Step>> out(nodes);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (!(conductance[k] > 0)) continue;
    const Edges image = contacts.image.empty()
                            ? Edges{}
                            : Edges{contacts.image[k][0], contacts.image[k][1], contacts.image[k][2]};
    out[at(contacts.i[k])].push_back({at(contacts.j[k]), image});
    out[at(contacts.j[k])].push_back({at(contacts.i[k]), {-image[0], -image[1], -image[2]}});
  }
  return out;
}

/// Axes along which contacts lead from a sphere to an image of itself, and so through any number of cells.
std::array<bool, 3> leading_axes(const Packing& packing, const Contacts& contacts,
                                 std::span<const double> conductance) {
  const auto steps = steps_from_each(packing.size(), contacts, conductance);
  std::vector<std::optional<Edges>> reached(packing.size());  // cell that a sphere is first met in
  std::array<bool, 3> leads{};
  for (std::size_t start = 0; start < packing.size(); ++start) {
    if (reached[start]) continue;
    reached[start] = Edges{};
    for (std::vector<std::size_t> ahead = {start}; !ahead.empty();) {
      const std::size_t node = ahead.back();
      ahead.pop_back();
      for (const auto& [to, across] : steps[node]) {
        Edges there = *reached[node];
        for (std::size_t k = 0; k < 3; ++k) there[k] += across[k];
        if (!reached[to]) {
          reached[to] = there;
          ahead.push_back(to);
        }
        for (std::size_t k = 0; k < 3; ++k) there[k] -= (*reached[to])[k];
        const Vec3 way = packing.cell->shift(there);
        for (std::size_t a = 0; a < 3; ++a) leads[a] = leads[a] || dot(axes[a], way) != 0;
      }
    }
  }
  return leads;
}

}  // namespace

ConductivityTensor periodic_conductivity(const Packing& packing, const Contacts& contacts,
                                         std::span<const double> conductance) {
  const Pinned pinned = pinned_graph(packing.size(), contacts, conductance);
  const Network network = build_network(pinned.graph, pinned.roles);
  std::vector<Vec3> branches;
  for (std::size_t k = 0; k < contacts.size(); ++k) branches.push_back(branch(packing, contacts, k));
  const bool is_trivial = network.size() == 0;
  std::optional<SpdSolver> solver;
  if (!is_trivial) solver.emplace(network);
  const auto leads = leading_axes(packing, contacts, conductance);
  ConductivityTensor tensor{};
  for (std::size_t b = 0; b < 3; ++b) {
    std::vector<double> load(network.size(), 0.0), theta(packing.size(), 0.0);
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const double drive = conductance[k] * dot(axes[b], branches[k]);
      if (const auto row = network.row_of_node[at(contacts.i[k])]; row >= 0) load[at(row)] += drive;
      if (const auto row = network.row_of_node[at(contacts.j[k])]; row >= 0) load[at(row)] -= drive;
    }
    if (solver) {
      const auto solution = solver->solve(load);
      for (std::size_t row = 0; row < solution.size(); ++row)
        theta[at(network.node_of_row[row])] = solution[row];
    }
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const double rise = dot(axes[b], branches[k]) + theta[at(contacts.j[k])] - theta[at(contacts.i[k])];
      for (std::size_t a = 0; a < 3; ++a)
        if (leads[a] && leads[b])  // else 0, and the solver's rounding
          tensor[a][b] += conductance[k] * rise * dot(axes[a], branches[k]) / packing.cell->volume();
    }
  }
  return tensor;
}

}  // namespace superstep
