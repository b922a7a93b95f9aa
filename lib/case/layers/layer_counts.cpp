#include "case/layers/layer_counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "case/selection.hpp"

namespace superstep {
namespace {

/// Layers that a process looks at; whose they will be is not known yet.
std::pair<std::int64_t, std::int64_t> share_of(const Lattice& lattice, const Communicator& among) {
  const std::int64_t layers = lattice.cells[2];
  return {layers * among.rank() / among.size(), layers * (among.rank() + 1) / among.size()};
}

struct Counted {
  std::vector<double> free;  // [layers looked at]
  double low = std::numeric_limits<double>::infinity(), high = -low;
  std::uint64_t radiating = 0, convecting = 0;
};

void count(const Graph& graph, std::int64_t layer, Counted& counted) {
  for (std::size_t k = 0; k < graph.nodes(); ++k) {
    if (k % static_cast<std::size_t>(layer) == 0) counted.free.push_back(0);
    if (!graph.is_fixed[k]) ++counted.free.back();
    const double value = graph.is_fixed[k] ? graph.fixed_value[k] : graph.initial[k];
    counted.low = std::min(counted.low, value);
    counted.high = std::max(counted.high, value);
  }
  counted.radiating += graph.radiation.size();
  counted.convecting += graph.convection.size();
}

/// Everybody's numbers one behind the other, everywhere.
std::vector<double> all_of(const std::vector<double>& own, Communicator& among) {
  std::vector<double> all = among.gather(own);
  std::vector<std::byte> bytes(all.size() * sizeof(double));
  if (!bytes.empty()) std::memcpy(bytes.data(), all.data(), bytes.size());
  among.broadcast(bytes);
  all.resize(bytes.size() / sizeof(double));
  if (!bytes.empty()) std::memcpy(all.data(), bytes.data(), bytes.size());
  return all;
}

/// A selection that holds nobody anywhere is a mistake.
void require_somebody(LayerReader& reader, Communicator& among) {
  // Who looked at no layer has seen no selection; the others have seen the same ones.
  if (reader.selections().empty()) (void)reader.read(0, 1, false);
  std::vector<std::string> empty;
  for (const auto& [place, somebody] : reader.selections())
    if (!among.any(somebody)) empty.push_back(place);
  if (!empty.empty()) throw InputError(fmt::format("{}; {}", empty.front(), selects_nobody));
}

}  // namespace

LayerFacts count_layers(LayeredNodes& nodes, Communicator& among) {
  const Lattice& lattice = nodes.lattice();
  Counted counted;
  agreed(among, [&] {
    const auto [first, last] = share_of(lattice, among);
    for (std::int64_t layer = first; layer < last; layer += nodes.stretch())
      count(nodes.reader().read(layer, std::min(layer + nodes.stretch(), last), false).field.graph,
            lattice.layer(), counted);
  });
  require_somebody(nodes.reader(), among);
  nodes.rows_before.assign(1, 0);
  for (const double free : all_of(counted.free, among))
    nodes.rows_before.push_back(nodes.rows_before.back() + static_cast<std::int64_t>(free));
  return {.low = among.min(counted.low),
          .high = among.max(counted.high),
          .radiates = among.sum(counted.radiating) > 0,
          .convects = among.sum(counted.convecting) > 0,
          .fixed = lattice.size() - nodes.rows()};
}

std::int64_t node_of_row(LayeredNodes& nodes, std::int64_t row) {
  if (row == 0) return 0;
  if (row == nodes.rows()) return nodes.lattice().size();
  const auto& before = nodes.rows_before;
  const std::int64_t layer = std::upper_bound(before.begin(), before.end(), row) - before.begin() - 1;
  const ReadLayers one = nodes.reader().read(layer, layer + 1, false);
  std::int64_t next = before[static_cast<std::size_t>(layer)];
  std::size_t k = 0;
  while (one.field.graph.is_fixed[k] || next++ != row) ++k;
  return one.first_node() + static_cast<std::int64_t>(k);
}

}  // namespace superstep
