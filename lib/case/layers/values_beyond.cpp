#include "case/layers/values_beyond.hpp"

#include <algorithm>
#include <utility>

#include "core/index.hpp"
#include "parallel/all_to_all.hpp"

namespace superstep {
namespace {

/// Behind the nodes that contacts of those before `end` can reach.
std::int64_t end_of_reach(const LayerSource& source, std::int64_t end) {
  return source.nodes_before(std::min(source.layer_of_node(end - 1) + 2, source.layers()));
}

}  // namespace

std::vector<double> values_beyond(const LayeredNodes& nodes, std::span<const double> own,
                                  Communicator& among) {
  if (among.alone()) return {};
  const IndexRange here{nodes.begin, nodes.end};
  std::vector<std::vector<double>> to;
  for (const IndexRange& has : everywhere(here, among)) {
    const IndexRange wanted =
        has.empty() ? IndexRange{} : IndexRange{has.end, end_of_reach(nodes.source(), has.end)};
    const IndexRange part = here.overlap(wanted);
    const auto values = part.empty() ? own.first(0) : own.subspan(at(part.begin - here.begin), part.size());
    to.emplace_back(values.begin(), values.end());
  }
  return all_to_all(std::move(to), among);
}

}  // namespace superstep
