#include "case/layers/layer_probes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/index.hpp"

namespace superstep {
namespace {

/// The free particle nearest to the middle of all; of several, the one with the lowest number.
std::int64_t mid_height(LayeredNodes& nodes) {
  const Lattice& lattice = nodes.lattice();
  std::int64_t nearest = 0;
  double smallest = std::numeric_limits<double>::infinity();
  const double top = lattice.spacing * static_cast<double>(lattice.cells[2] - 1);
  const auto away = [&](std::int64_t layer) {
    return std::abs(lattice.spacing * static_cast<double>(layer) - 0.5 * top);
  };
  const auto look = [&](std::int64_t layer) {
    if (layer < 0 || layer >= lattice.cells[2] || away(layer) > smallest + lattice.spacing) return false;
    const ReadLayers one = nodes.reader().read(layer, layer + 1, false);
    const Bounds box = surface_bounds(one.packed.packing);
    const Vec3 middle = 0.5 * (box.min + box.max);
    for (std::size_t k = 0; k < one.field.graph.nodes(); ++k) {
      const double distance = norm(one.packed.packing.centre[k] - middle);
      const std::int64_t node = one.first_node() + static_cast<std::int64_t>(k);
      if (one.field.graph.is_fixed[k] || distance > smallest || (distance == smallest && node > nearest))
        continue;
      smallest = distance;
      nearest = node;
    }
    return true;
  };
  const std::int64_t middle = (lattice.cells[2] - 1) / 2;
  for (std::int64_t step = 0; step < lattice.cells[2]; ++step) {
    const bool below = look(middle - step), above = step > 0 && look(middle + step);
    if (!below && !above && step > 0) break;
  }
  return nearest;
}

std::int64_t probed_node(const TomlValue& value, LayeredNodes& nodes) {
  if (!value.is_string()) {
    const std::int64_t node = value.integer();
    if (node < 0 || node >= nodes.lattice().size()) value.reject("it must be the id of a node");
    return node;
  }
  if (value.string() != "mid-height") value.reject("it must be \"mid-height\", an id, or a list of these");
  return mid_height(nodes);
}

void add(const TomlValue& value, LayeredNodes& nodes, Scene& scene) {
  const std::int64_t node = probed_node(value, nodes), layer = nodes.layer_of_node(node);
  const ReadLayers one = nodes.reader().read(layer, layer + 1, false);
  const Graph& from = one.field.graph;
  const auto here = at(node - one.first_node());
  const auto before =
      std::count(from.is_fixed.begin(), from.is_fixed.begin() + static_cast<std::ptrdiff_t>(here), 0);
  FieldScene& field = scene.fields.front();
  scene.probes.push_back({value.is_string() ? "mid-height" : std::to_string(node), node,
                          static_cast<std::int32_t>(field.graph.id.size())});
  field.graph.id.push_back(node);
  field.graph.initial.push_back(from.initial[here]);
  field.graph.fixed_value.push_back(from.fixed_value[here]);
  field.graph.is_fixed.push_back(from.is_fixed[here]);
  field.row_of_node.push_back(
      from.is_fixed[here] ? -1 : static_cast<std::int32_t>(nodes.rows_before[at(layer)] + before));
}

}  // namespace

void read_layer_probes(LayeredNodes& nodes, Scene& scene) {
  const auto probe = nodes.reader().root().find("probe");
  if (!probe) return;
  if (!probe->is_array()) return add(*probe, nodes, scene);
  for (const auto& value : probe->array()) {
    add(value, nodes, scene);
    const auto same = [&](const Probe& other) { return other.label == scene.probes.back().label; };
    if (std::count_if(scene.probes.begin(), scene.probes.end(), same) > 1)
      value.reject("it stands twice; keep one");
  }
}

}  // namespace superstep
