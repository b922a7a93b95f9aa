#include "case/parts/part_clusters.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "parallel/all_to_all.hpp"

namespace superstep {
namespace {

struct Adrift {
  std::uint64_t moving = 0, idle = 0;
  bool something_moves = false;
  void count(const ComponentFacts& facts) {
    something_moves = something_moves || (facts.has_free && !facts.idle());
    if (facts.floats() && !facts.exchanges) ++(facts.idle() ? idle : moving);
  }
};

}  // namespace

PartClusters::PartClusters(std::int64_t begin, std::int64_t end)
    : begin_(begin), end_(end), sets_(at(end - begin)), facts_(at(end - begin)) {}

void PartClusters::join(std::int64_t i, std::int64_t j) {
  if (j < end_)
    sets_.join(static_cast<std::uint32_t>(i - begin_), static_cast<std::uint32_t>(j - begin_));
  else
    beyond_.push_back({root_of(i), j});
}

/// Edges between components of two processes, each named by a node of it.
std::vector<PartClusters::Edge> PartClusters::name_by_roots(Communicator& among) {
  const auto ranges = everywhere(IndexRange{begin_, end_}, among);
  std::vector<std::vector<Edge>> to(ranges.size());
  for (const auto& [i, j] : beyond_) to[range_that_holds(ranges, j)].push_back({root_of(i), j});
  auto joined = all_to_all(std::move(to), among);
  for (auto& edge : joined) edge.j = root_of(edge.j);
  const auto key = [](const Edge& edge) { return std::pair(edge.i, edge.j); };
  std::sort(joined.begin(), joined.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  joined.erase(std::unique(joined.begin(), joined.end(),
                           [&](const auto& a, const auto& b) { return key(a) == key(b); }),
               joined.end());
  return joined;
}

std::uint64_t PartClusters::count_adrift(Communicator& among) && {
  for (std::int64_t node = begin_; node < end_; ++node)
    if (const std::int64_t root = root_of(node); root != node)
      facts_[at(root - begin_)].take(std::exchange(facts_[at(node - begin_)], {}));
  const std::vector<Edge> joined = name_by_roots(among);
  std::vector<char> is_shared(facts_.size(), 0);
  for (const auto& [i, j] : beyond_) is_shared[at(root_of(i) - begin_)] = 1;
  for (const auto& edge : joined) is_shared[at(edge.j - begin_)] = 1;
  Adrift adrift;
  std::vector<std::vector<Cluster>> clusters(at(among.size()));
  std::vector<std::vector<Edge>> edges(at(among.size()));
  for (std::size_t k = 0; k < facts_.size(); ++k) {
    if (!facts_[k].seen) continue;  // no root
    if (is_shared[k])
      clusters.front().push_back({begin_ + static_cast<std::int64_t>(k), facts_[k]});
    else
      adrift.count(facts_[k]);
  }
  edges.front() = joined;
  // The root joins the few that several processes share.
  const auto shared = all_to_all(std::move(clusters), among);
  const auto between = all_to_all(std::move(edges), among);
  std::map<std::int64_t, std::uint32_t> number;
  for (const auto& cluster : shared) number.emplace(cluster.root, static_cast<std::uint32_t>(number.size()));
  DisjointSets sets(number.size());
  for (const auto& [i, j] : between) sets.join(number.at(i), number.at(j));
  std::vector<ComponentFacts> whole(number.size());
  for (const auto& cluster : shared) whole[sets.root(number.at(cluster.root))].take(cluster.facts);
  for (const auto& one : whole)
    if (one.seen) adrift.count(one);
  const std::uint64_t moving = among.sum(adrift.moving), idle = among.sum(adrift.idle);
  return moving + (among.any(adrift.something_moves) ? 0 : idle);
}

}  // namespace superstep
