#include "case/network/parts/shared_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "case/network/parts/byte_pieces.hpp"
#include "case/parts/agreed.hpp"
#include "core/index.hpp"
#include "parallel/all_to_all.hpp"

namespace superstep {
namespace {

using ToAll = std::vector<std::vector<SharedEdge>>;

class Sharing {
 public:
  Sharing(const RowsInParts& table, const SharedNodes& nodes, const NodeDirectory& directory,
          Communicator& among)
      : table_(table), nodes_(nodes), directory_(directory), among_(among) {}

  /// Those of a piece of each process. Edges go to who knows their first end, from there to who knows the
  /// other one, and then to the owners of both.
  [[nodiscard]] std::vector<SharedEdge> share(std::uint64_t first, std::uint64_t last) const {
    ToAll to = nobody();
    agreed(among_, [&] {
      std::uint64_t number = first;  // no row is shorter than a byte
      for (const auto& row : edges_of_part(table_, first, last))
        to[directory_.process(row.i)].push_back({row.i, row.j, row.conductance, number++});
    });
    std::vector<SharedEdge> edges = with_nodes(&SharedEdge::i, std::move(to));
    to = nobody();
    for (const auto& edge : edges) to[directory_.process(edge.j)].push_back(edge);
    std::vector<SharedEdge>().swap(edges);
    edges = with_nodes(&SharedEdge::j, std::move(to));
    to = nobody();
    for (auto& edge : edges) {
      std::tie(edge.i, edge.j) = std::pair(std::min(edge.i, edge.j), std::max(edge.i, edge.j));
      const std::size_t a = nodes_.owner(edge.i), b = nodes_.owner(edge.j);
      to[a].push_back(edge);
      if (b != a) to[b].push_back(edge);
    }
    std::vector<SharedEdge>().swap(edges);
    return all_to_all(std::move(to), among_);
  }

 private:
  [[nodiscard]] ToAll nobody() const { return ToAll(at(among_.size())); }
  /// What arrives, with the nodes of one end instead of their ids, all of which are known here.
  [[nodiscard]] std::vector<SharedEdge> with_nodes(std::int64_t SharedEdge::*end, ToAll to) const {
    std::vector<SharedEdge> edges = all_to_all(std::move(to), among_);
    agreed(among_, [&] {
      for (auto& edge : edges) {
        const std::int64_t id = edge.*end;
        edge.*end = directory_.node_of(id);
        if (edge.*end < 0)
          throw InputError(fmt::format(
              "{}: edge end {} is not a node; every end must be an id of the nodes file", table_.path(), id));
      }
    });
    return edges;
  }

  const RowsInParts& table_;
  const SharedNodes& nodes_;
  const NodeDirectory& directory_;
  Communicator& among_;
};

/// Sums what runs parallel into the first of it, in the order of the file.
std::size_t join_parallel(std::vector<SharedEdge>& edges, const IndexRange& counted) {
  const auto place = [](const SharedEdge& edge) { return std::tuple(edge.i, edge.j, edge.number); };
  std::sort(edges.begin(), edges.end(),
            [&](const SharedEdge& a, const SharedEdge& b) { return place(a) < place(b); });
  std::size_t kept = 0, joined = 0;
  for (const auto& edge : edges) {
    if (kept > 0 && edges[kept - 1].i == edge.i && edges[kept - 1].j == edge.j) {
      edges[kept - 1].conductance += edge.conductance;
      if (counted.holds(edge.i)) ++joined;
    } else {
      edges[kept++] = edge;
    }
  }
  edges.resize(kept);
  std::sort(edges.begin(), edges.end(),
            [](const SharedEdge& a, const SharedEdge& b) { return a.number < b.number; });
  return joined;
}

}  // namespace

SharedEdges share_edges(const RowsInParts& table, const SharedNodes& nodes, const NodeDirectory& directory,
                        Communicator& among) {
  const BytePieces pieces(table, among);
  const int rounds = static_cast<int>(among.max(pieces.count()));
  const Sharing sharing(table, nodes, directory, among);
  SharedEdges edges;
  for (int round = 0; round < rounds; ++round) {
    const auto more = sharing.share(pieces.begin(round), pieces.begin(round + 1));
    if (round == 0) edges.own.reserve(more.size() * static_cast<std::size_t>(rounds));
    edges.own.insert(edges.own.end(), more.begin(), more.end());
  }
  const std::size_t joined = join_parallel(edges.own, nodes.here());
  const auto is_counted = [&](const SharedEdge& edge) { return nodes.here().holds(edge.i); };
  edges.count =
      among.sum(static_cast<std::uint64_t>(std::count_if(edges.own.begin(), edges.own.end(), is_counted)));
  edges.joined = among.sum(joined);
  return edges;
}

}  // namespace superstep
