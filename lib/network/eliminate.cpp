#include "network/eliminate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/error.hpp"
#include "core/index.hpp"
#include "network/files/read_network.hpp"

namespace superstep {
namespace {

/// Everything that leads away from one algebraic node.
struct Star {
  std::map<std::int32_t, double> edge;                         ///< other node -> conductance
  std::map<std::pair<double, std::int32_t>, double> exchange;  ///< ambient -> coefficient
  std::vector<std::pair<std::int32_t, double>> tabled;         ///< sources: table, factor
  double source = 0;

  [[nodiscard]] double sum() const {
    double out = 0;
    for (const auto& [node, conductance] : edge) out += conductance;
    for (const auto& [ambient, coefficient] : exchange) out += coefficient;
    return out;
  }
};

class Elimination {
 public:
  Elimination(Graph& graph, std::string where) : graph_(graph), where_(std::move(where)) {
    star_of_.assign(graph.nodes(), -1);
    for (std::size_t node = 0; node < graph.nodes(); ++node) {
      if (graph.is_fixed[node] || graph.capacity[node] > 0) continue;
      star_of_[node] = static_cast<std::int32_t>(stars_.size());
      node_.push_back(static_cast<std::int32_t>(node));
      stars_.emplace_back();
      stars_.back().source = graph.source[node];
    }
  }
  [[nodiscard]] bool has_work() const noexcept { return !stars_.empty(); }

  std::vector<AlgebraicNode> run() {
    require_something_left();
    take_edges();
    take_inputs();
    std::set<std::pair<std::size_t, std::int32_t>> queue;  // fewest neighbours first: less fill
    for (std::size_t s = 0; s < stars_.size(); ++s)
      queue.insert({stars_[s].edge.size(), static_cast<std::int32_t>(s)});
    std::vector<AlgebraicNode> out;
    while (!queue.empty()) {
      const std::int32_t s = queue.begin()->second;
      queue.erase(queue.begin());
      std::vector<std::int32_t> touched;
      for (const auto& [node, conductance] : stars_[at(s)].edge)
        if (const auto other = star_of_[at(node)]; other >= 0) touched.push_back(other);
      for (const auto other : touched) queue.erase({stars_[at(other)].edge.size(), other});
      out.push_back(eliminate(s));
      for (const auto other : touched) queue.insert({stars_[at(other)].edge.size(), other});
    }
    for (const auto& [ends, conductance] : fill_)
      add_edge(graph_, at(ends.first), at(ends.second), conductance);
    for (const auto& [key, coefficient] : new_exchange_)
      graph_.convection.push_back({key.first, coefficient, key.second.first, key.second.second});
    return out;
  }

 private:
  [[nodiscard]] std::int64_t id(std::int32_t star) const { return graph_.id[at(node_[at(star)])]; }

  void require_something_left() const {
    for (std::size_t node = 0; node < graph_.nodes(); ++node)
      if (!graph_.is_fixed[node] && star_of_[node] < 0) return;
    throw InputError(fmt::format(
        "{}: every free node has capacity 0, so that nothing changes in time; give at least one a "
        "capacity",
        where_));
  }

  /// Moves every edge that ends at an algebraic node out of the graph.
  void take_edges() {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < graph_.edges(); ++k) {
      const auto i = graph_.i[k], j = graph_.j[k];
      const double conductance = graph_.conductance[k];
      const bool is_free = star_of_[at(i)] < 0 && star_of_[at(j)] < 0;
      if (is_free) {
        graph_.i[kept] = i;
        graph_.j[kept] = j;
        graph_.conductance[kept++] = conductance;
      } else if (conductance > 0) {
        join(i, j, conductance);
      }
    }
    graph_.i.resize(kept);
    graph_.j.resize(kept);
    graph_.conductance.resize(kept);
  }

  void take_inputs() {
    for (const auto& exchange : graph_.radiation)
      if (const auto s = star_of_[at(exchange.node)]; s >= 0)
        throw InputError(
            fmt::format("{}: node {} has capacity 0 and radiates; give it a capacity", where_, id(s)));
    std::erase_if(graph_.convection, [&](const AmbientExchange& exchange) {
      const auto s = star_of_[at(exchange.node)];
      if (s >= 0) stars_[at(s)].exchange[{exchange.ambient, exchange.table}] += exchange.coefficient;
      return s >= 0;
    });
    std::erase_if(graph_.tabled_sources, [&](const TabledSource& source) {
      const auto s = star_of_[at(source.node)];
      if (s >= 0) stars_[at(s)].tabled.push_back({source.table, 1.0});
      return s >= 0;
    });
  }

  void join(std::int32_t a, std::int32_t b, double conductance) {
    const auto star_a = star_of_[at(a)], star_b = star_of_[at(b)];
    if (star_a >= 0) stars_[at(star_a)].edge[b] += conductance;
    if (star_b >= 0) stars_[at(star_b)].edge[a] += conductance;
    if (star_a < 0 && star_b < 0) fill_[{std::min(a, b), std::max(a, b)}] += conductance;
  }

  void feed(std::int32_t node, double source) {
    if (graph_.is_fixed[at(node)]) return;
    if (const auto s = star_of_[at(node)]; s >= 0)
      stars_[at(s)].source += source;
    else
      graph_.source[at(node)] += source;
  }

  /// A part of a table as a source of another node.
  void feed_table(std::int32_t node, std::int32_t table, double factor) {
    if (graph_.is_fixed[at(node)]) return;
    if (const auto s = star_of_[at(node)]; s >= 0) {
      stars_[at(s)].tabled.push_back({table, factor});
      return;
    }
    TimeTable part = graph_.tables[at(table)];
    for (double& value : part.value) value *= factor;
    graph_.tabled_sources.push_back({node, static_cast<std::int32_t>(graph_.tables.size())});
    graph_.tables.push_back(std::move(part));
  }

  void exchange(std::int32_t node, const std::pair<double, std::int32_t>& ambient, double coefficient) {
    if (const auto s = star_of_[at(node)]; s >= 0)
      stars_[at(s)].exchange[ambient] += coefficient;
    else if (!graph_.is_fixed[at(node)])
      new_exchange_[{node, ambient}] += coefficient;
  }

  AlgebraicNode eliminate(std::int32_t s) {
    const std::int32_t node = node_[at(s)];
    const Star star = std::move(stars_[at(s)]);
    stars_[at(s)] = {};
    star_of_[at(node)] = -1;
    const double sum = star.sum();
    if (!(sum > 0))
      throw InputError(fmt::format(
          "{}: node {} has capacity 0 and no connection, direct or through others like it, to a node "
          "that has one or is fixed: nothing determines its value; give it a capacity, or an edge",
          where_, graph_.id[at(node)]));
    constexpr std::size_t most = 3000;  // neighbours: the mesh would have millions of edges
    if (star.edge.size() > most)
      throw InputError(fmt::format(
          "{}: node {} has capacity 0 and, once others like it are eliminated, {} neighbours, all of "
          "which would be joined with each other; give it a small capacity",
          where_, graph_.id[at(node)], star.edge.size()));
    AlgebraicNode out{.node = node, .weight = {}, .constant = star.source / sum, .tabled = {}};
    for (const auto& [other, conductance] : star.edge) {
      out.weight.push_back({other, conductance / sum});
      if (const auto t = star_of_[at(other)]; t >= 0) stars_[at(t)].edge.erase(node);
    }
    for (const auto& [ambient, coefficient] : star.exchange) {
      if (ambient.second >= 0)
        out.tabled.push_back({ambient.second, coefficient / sum});
      else
        out.constant += coefficient * ambient.first / sum;
    }
    for (const auto& [table, factor] : star.tabled) out.tabled.push_back({table, factor / sum});
    for (auto a = star.edge.begin(); a != star.edge.end(); ++a) {
      const double part = a->second / sum;
      // Also between held nodes: it moves no unknown, but their current flows through it.
      for (auto b = std::next(a); b != star.edge.end(); ++b) join(a->first, b->first, part * b->second);
      for (const auto& [ambient, coefficient] : star.exchange)
        exchange(a->first, ambient, part * coefficient);
      for (const auto& [table, factor] : star.tabled) feed_table(a->first, table, part * factor);
      feed(a->first, part * star.source);
    }
    graph_.source[at(node)] = 0;
    graph_.capacity[at(node)] = 1;
    return out;
  }

  Graph& graph_;
  std::string where_;
  std::vector<std::int32_t> star_of_, node_;
  std::vector<Star> stars_;
  std::map<std::pair<std::int32_t, std::int32_t>, double> fill_;
  std::map<std::pair<std::int32_t, std::pair<double, std::int32_t>>, double> new_exchange_;
};

}  // namespace

std::vector<AlgebraicNode> eliminate_algebraic_nodes(Graph& graph, const std::string& where) {
  Elimination elimination(graph, where);
  if (!elimination.has_work()) return {};
  auto out = elimination.run();
  (void)join_parallel_edges(graph);
  return out;
}

void recover_algebraic_values(const std::vector<AlgebraicNode>& nodes, const Graph& graph, double t,
                              std::vector<double>& value) {
  for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
    double sum = node->constant;
    for (const auto& [other, weight] : node->weight) sum += weight * value[at(other)];
    for (const auto& [table, factor] : node->tabled) sum += factor * graph.tables[at(table)].at(t);
    value[at(node->node)] = sum;
  }
}

}  // namespace superstep
