#include "case/layers/values_beyond.hpp"

#include <algorithm>
#include <cstring>

#include "core/index.hpp"
#include "parallel/all_to_all.hpp"

namespace superstep {
namespace {

struct NodeRange {
  std::int64_t begin = 0, end = 0;
  [[nodiscard]] bool empty() const noexcept { return begin >= end; }
  [[nodiscard]] std::size_t size() const noexcept { return empty() ? 0 : at(end - begin); }
};

NodeRange overlap(const NodeRange& a, const NodeRange& b) {
  return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}

/// Nodes of each process, everywhere.
std::vector<NodeRange> ranges_of_all(const LayeredNodes& nodes, Communicator& among) {
  const double own[] = {static_cast<double>(nodes.begin), static_cast<double>(nodes.end)};
  const std::vector<double> ends = everywhere(own, among);
  std::vector<NodeRange> ranges;
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2)
    ranges.push_back({static_cast<std::int64_t>(ends[k]), static_cast<std::int64_t>(ends[k + 1])});
  return ranges;
}

/// Behind the nodes that contacts of those before `end` can reach.
std::int64_t end_of_reach(const LayerSource& source, std::int64_t end) {
  if (end == 0) return 0;
  return source.nodes_before(std::min(source.layer_of_node(end - 1) + 2, source.layers()));
}

}  // namespace

std::vector<double> values_beyond(const LayeredNodes& nodes, std::span<const double> own,
                                  Communicator& among) {
  if (among.alone()) return {};
  const auto ranges = ranges_of_all(nodes, among);
  const auto wanted_by = [&](int rank) {
    const NodeRange& has = ranges[at(rank)];
    return has.empty() ? NodeRange{} : NodeRange{has.end, end_of_reach(nodes.source(), has.end)};
  };
  // Everybody sends to lower ranks first, and the lowest one to nobody: nobody waits for ever.
  const NodeRange here{nodes.begin, nodes.end};
  for (int to = among.rank() - 1; to >= 0; --to)
    if (const NodeRange part = overlap(here, wanted_by(to)); !part.empty())
      among.send(to, std::as_bytes(own.subspan(at(part.begin - here.begin), part.size())));
  const NodeRange wanted = wanted_by(among.rank());
  std::vector<double> values(wanted.size());
  for (int from = among.rank() + 1; from < among.size(); ++from) {
    const NodeRange part = overlap(wanted, ranges[at(from)]);
    if (part.empty()) continue;
    const auto bytes = among.receive(from);
    std::memcpy(values.data() + (part.begin - wanted.begin), bytes.data(), bytes.size());
  }
  return values;
}

}  // namespace superstep
