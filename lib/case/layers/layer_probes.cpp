#include "case/layers/layer_probes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "case/probe.hpp"
#include "core/index.hpp"
#include "core/text/ids_in_words.hpp"

namespace superstep {
namespace {

/// Looks at layers from the middle outwards, as long as they can hold a nearer one.
std::int64_t mid_height(LayeredNodes& nodes) {
  const Lattice& lattice = nodes.lattice();
  MidHeight found(surface_bounds(lattice_layers(lattice, 0, 1)));
  const double top = lattice.spacing * static_cast<double>(lattice.cells[2] - 1);
  const auto look = [&](std::int64_t layer) {
    const double away = std::abs(lattice.spacing * static_cast<double>(layer) - 0.5 * top);
    if (layer < 0 || layer >= lattice.cells[2] || away > found.distance() + lattice.spacing) return false;
    const ReadLayers one = nodes.reader().read(layer, layer + 1, false);
    for (std::size_t k = 0; k < one.field.graph.nodes(); ++k)
      if (!one.field.graph.is_fixed[k])
        found.look_at(one.packed.packing.centre[k], one.first_node() + static_cast<std::int64_t>(k));
    return true;
  };
  const std::int64_t middle = (lattice.cells[2] - 1) / 2;
  for (std::int64_t step = 0; step < lattice.cells[2]; ++step) {
    const bool below = look(middle - step), above = step > 0 && look(middle + step);
    if (!below && !above && step > 0) break;
  }
  return found.nearest();
}

/// Takes the node into the graph of the probed ones.
Probe add(const std::string& label, std::int64_t node, LayeredNodes& nodes, FieldScene& field) {
  const std::int64_t layer = nodes.layer_of_node(node);
  const ReadLayers one = nodes.reader().read(layer, layer + 1, false);
  const Graph& from = one.field.graph;
  const auto here = at(node - one.first_node());
  const auto before =
      std::count(from.is_fixed.begin(), from.is_fixed.begin() + static_cast<std::ptrdiff_t>(here), 0);
  field.graph.id.push_back(node);
  field.graph.initial.push_back(from.initial[here]);
  field.graph.fixed_value.push_back(from.fixed_value[here]);
  field.graph.is_fixed.push_back(from.is_fixed[here]);
  field.row_of_node.push_back(
      from.is_fixed[here] ? -1 : static_cast<std::int32_t>(nodes.rows_before[at(layer)] + before));
  return {label, node, static_cast<std::int32_t>(field.graph.id.size()) - 1};
}

}  // namespace

void read_layer_probes(LayeredNodes& nodes, Scene& scene) {
  const auto probe = nodes.reader().root().find("probe");
  if (!probe) return;
  FieldScene& field = scene.fields.front();
  const auto by_id = [&](const TomlValue& value) {
    const std::int64_t node = value.integer();
    if (node < 0 || node >= nodes.lattice().size())
      value.reject("it must be the id of a node; " + ids_in_words(0, nodes.lattice().size() - 1));
    return add(std::to_string(node), node, nodes, field);
  };
  const auto at_mid_height = [&](const TomlValue&) {
    return add("mid-height", mid_height(nodes), nodes, field);
  };
  scene.probes = read_probes(*probe, {.by_id = by_id, .at_mid_height = at_mid_height});
}

}  // namespace superstep
