#include "case/layers/layer_probes.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "case/probe.hpp"
#include "core/index.hpp"
#include "core/text/ids_in_words.hpp"

namespace superstep {
namespace {

/// Everybody looks at the own nodes, in the nearest layers first, as long as they can hold a nearer one.
std::int64_t mid_height(LayeredNodes& nodes, Communicator& among) {
  LayerSource& source = nodes.source();
  const Bounds box = surface_bounds(source.sample());
  const Vec3 middle = 0.5 * (box.min + box.max);
  const auto [around, end] = nodes.layers_around();
  source.bring(around, end, among);
  std::vector<std::pair<double, std::int64_t>> layers;  // by their distance
  nodes.for_stretches([&](std::int64_t first, std::int64_t last) {
    for (std::int64_t layer = first; layer < last; ++layer)
      layers.emplace_back(source.distance(layer, layer + 1, middle), layer);
  });
  std::sort(layers.begin(), layers.end());
  MidHeight found(box);
  for (const auto& [distance, layer] : layers) {
    if (distance > found.distance()) break;
    const ReadLayers one = nodes.reader().read(layer, layer + 1, false);
    for (std::size_t k = 0; k < one.field.graph.nodes(); ++k) {
      const std::int64_t node = one.first_node + static_cast<std::int64_t>(k);
      if (!one.field.graph.is_fixed[k] && node >= nodes.begin && node < nodes.end)
        found.look_at(one.packed.packing.centre[k], node);
    }
  }
  const double distance = among.min(found.distance());
  const bool is_nearest = found.distance() == distance;
  return static_cast<std::int64_t>(
      among.min(is_nearest ? static_cast<double>(found.nearest()) : std::numeric_limits<double>::infinity()));
}

/// Takes the node into the graph of the probed ones.
Probe add(const std::string& label, std::int64_t node, LayeredNodes& nodes, FieldScene& field,
          Communicator& among) {
  const std::int64_t layer = nodes.source().layer_of_node(node);
  nodes.source().bring(layer, layer + 1, among);
  const ReadLayers one = nodes.reader().read(layer, layer + 1, false);
  const Graph& from = one.field.graph;
  const auto here = at(node - one.first_node);
  const auto before =
      std::count(from.is_fixed.begin(), from.is_fixed.begin() + static_cast<std::ptrdiff_t>(here), 0);
  field.graph.id.push_back(from.id[here]);
  field.graph.initial.push_back(from.initial[here]);
  field.graph.fixed_value.push_back(from.fixed_value[here]);
  field.graph.is_fixed.push_back(from.is_fixed[here]);
  field.row_of_node.push_back(
      from.is_fixed[here] ? -1 : static_cast<std::int32_t>(nodes.rows_before[at(layer)] + before));
  return {label, from.id[here], static_cast<std::int32_t>(field.graph.id.size()) - 1};
}

}  // namespace

void read_layer_probes(LayeredNodes& nodes, Scene& scene, Communicator& among) {
  const auto probe = nodes.reader().root().find("probe");
  if (!probe) return;
  FieldScene& field = scene.fields.front();
  const auto by_id = [&](const TomlValue& value) {
    const std::int64_t id = value.integer(), node = nodes.source().node_of_id(id, among);
    if (node < 0) value.reject("it must be the id of a node; " + ids_in_words(0, nodes.source().nodes() - 1));
    return add(std::to_string(id), node, nodes, field, among);
  };
  const auto at_mid_height = [&](const TomlValue&) {
    return add("mid-height", mid_height(nodes, among), nodes, field, among);
  };
  scene.probes = read_probes(*probe, {.by_id = by_id, .at_mid_height = at_mid_height});
}

}  // namespace superstep
