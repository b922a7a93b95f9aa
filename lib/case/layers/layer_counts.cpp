#include "case/layers/layer_counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "case/parts/agreed.hpp"
#include "case/selection.hpp"
#include "parallel/all_to_all.hpp"

namespace superstep {
namespace {

struct Counted {
  std::vector<double> free;  // [layers looked at]
  double low = std::numeric_limits<double>::infinity(), high = -low;
  std::uint64_t radiating = 0, convecting = 0;
};

/// Of a graph that begins with a layer.
void count(const Graph& graph, const LayerSource& source, std::int64_t layer, Counted& counted) {
  const std::int64_t first_node = source.nodes_before(layer);
  for (std::size_t k = 0; k < graph.nodes(); ++k) {
    while (source.nodes_before(layer) <= first_node + static_cast<std::int64_t>(k)) {
      counted.free.push_back(0);
      ++layer;
    }
    if (!graph.is_fixed[k]) ++counted.free.back();
    const double value = graph.is_fixed[k] ? graph.fixed_value[k] : graph.initial[k];
    counted.low = std::min(counted.low, value);
    counted.high = std::max(counted.high, value);
  }
  counted.radiating += graph.radiation.size();
  counted.convecting += graph.convection.size();
}

/// Places of a log that say no on all processes, everywhere the same. Who looked at no layer has an empty
/// log; the others have seen the same places.
std::vector<std::string> never_true(const SelectionLog& log, Communicator& among) {
  const auto count = static_cast<std::size_t>(among.max(static_cast<double>(log.size())));
  std::vector<std::string> never;
  auto next = log.begin();
  for (std::size_t k = 0; k < count; ++k) {
    const bool here = next != log.end();
    const auto place = among.first_of(here ? std::optional(next->first) : std::nullopt);
    if (!among.any(here && next->second)) never.push_back(*place);
    if (here) ++next;
  }
  return never;
}

}  // namespace

LayerFacts count_layers(LayeredNodes& nodes, Communicator& among) {
  const LayerSource& source = nodes.source();
  Counted counted;
  agreed(among, [&] {
    const auto [first, last] = source.first_share(among);
    for (std::int64_t layer = first; layer < last; layer += nodes.stretch()) {
      const std::int64_t end = std::min(layer + nodes.stretch(), last);
      count(nodes.reader().read(layer, end, false).field.graph, source, layer, counted);
      counted.free.resize(static_cast<std::size_t>(end - first), 0.0);  // layers without spheres
    }
  });
  const auto nobody = never_true(nodes.reader().selections(), among);
  if (!nobody.empty()) throw InputError(fmt::format("{}; {}", nobody.front(), selects_nobody));
  nodes.rows_before.assign(1, 0);
  for (const double free : everywhere(counted.free, among))
    nodes.rows_before.push_back(nodes.rows_before.back() + static_cast<std::int64_t>(free));
  return {.low = among.min(counted.low),
          .high = among.max(counted.high),
          .radiates = among.sum(counted.radiating) > 0,
          .convects = among.sum(counted.convecting) > 0,
          .fixed = source.nodes() - nodes.rows(),
          .feeding_nobody = never_true(nodes.reader().fed(), among)};
}

std::int64_t node_of_row(LayeredNodes& nodes, std::int64_t row, Communicator& among) {
  const auto& before = nodes.rows_before;
  const bool between = row > 0 && row < nodes.rows();
  const std::int64_t layer =
      between ? std::upper_bound(before.begin(), before.end(), row) - before.begin() - 1 : 0;
  nodes.source().bring(layer, layer + (between ? 1 : 0), among);
  if (!between) return row == 0 ? 0 : nodes.source().nodes();
  const ReadLayers one = nodes.reader().read(layer, layer + 1, false);
  std::int64_t next = before[static_cast<std::size_t>(layer)];
  std::size_t k = 0;
  while (one.field.graph.is_fixed[k] || next++ != row) ++k;
  return one.first_node + static_cast<std::int64_t>(k);
}

}  // namespace superstep
