#include "case/network/parts/local_network.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/index.hpp"
#include "network/network_in_order.hpp"

namespace superstep {
namespace {

/// Other ends of edges, once each, in order.
std::vector<std::int64_t> ends_beyond(const std::vector<SharedEdge>& edges, const IndexRange& here) {
  std::vector<std::int64_t> ends;
  for (const auto& edge : edges)
    for (const std::int64_t end : {edge.i, edge.j})
      if (!here.holds(end)) ends.push_back(end);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

}  // namespace

void add_node(const SharedNode& node, Graph& graph) {
  graph.id.push_back(node.id);
  graph.capacity.push_back(node.capacity);
  graph.source.push_back(node.source);
  graph.initial.push_back(node.initial);
  graph.fixed_value.push_back(node.fixed_value);
  graph.is_fixed.push_back(node.is_fixed() ? 1 : 0);
}

LocalNetwork::LocalNetwork(const SharedNodes& nodes, const std::vector<SharedEdge>& edges,
                           Communicator& among)
    : here_(nodes.here()), beyond_(ends_beyond(edges, here_)) {
  const std::vector<SharedNode> others = nodes.ask(beyond_, among);
  below_ = static_cast<std::size_t>(std::lower_bound(beyond_.begin(), beyond_.end(), here_.begin) -
                                    beyond_.begin());
  const auto take = [&](const SharedNode& node) {
    add_node(node, graph_);
    row_.push_back(node.row);
    roles_.push_back(node.is_fixed() ? NodeRole::fixed : NodeRole::free);
  };
  for (std::size_t k = 0; k < below_; ++k) take(others[k]);
  for (const auto& node : nodes.own()) take(node);
  for (std::size_t k = below_; k < others.size(); ++k) take(others[k]);
  const auto place = [&](std::int64_t number) {
    if (here_.holds(number)) return below_ + at(number - here_.begin);
    const auto other = at(std::lower_bound(beyond_.begin(), beyond_.end(), number) - beyond_.begin());
    return other < below_ ? other : other + here_.size();
  };
  graph_.i.reserve(edges.size());
  graph_.j.reserve(edges.size());
  graph_.conductance.reserve(edges.size());
  for (const auto& edge : edges) add_edge(graph_, place(edge.i), place(edge.j), edge.conductance);
}

std::int64_t LocalNetwork::number(std::size_t node) const noexcept {
  if (node < below_) return beyond_[node];
  const std::size_t own = node - below_;
  return own < here_.size() ? here_.begin + static_cast<std::int64_t>(own) : beyond_[node - here_.size()];
}

double LocalNetwork::pair_step() const {
  return min_pair_step(graph_, roles_, graph_.conductance);
}

std::vector<double> LocalNetwork::initial(double origin) const {
  std::vector<double> values;
  for (std::size_t k = below_; k < below_ + here_.size(); ++k)
    if (roles_[k] == NodeRole::free) values.push_back(graph_.initial[k] - origin);
  return values;
}

NetworkPart LocalNetwork::part(double origin) && {
  std::vector<std::int32_t> order(graph_.nodes());
  std::iota(order.begin(), order.end(), 0);
  const Network network = build_network_in_order(graph_, roles_, origin, order);
  graph_ = {};
  const auto free_before = [&](std::size_t end) {
    return std::count(roles_.begin(), roles_.begin() + static_cast<std::ptrdiff_t>(end), NodeRole::free);
  };
  NetworkPart part = rows_of(network, {free_before(below_), free_before(below_ + here_.size())});
  for (auto& row : part.halo) row = row_[at(network.node_of_row[at(row)])];
  part.network.node_of_row = {};
  part.network.node_of_halo = {};
  return part;
}

}  // namespace superstep
