#include "case/probe.hpp"

#include <algorithm>
#include <limits>

namespace superstep {
namespace {

/// The free particle nearest to the axis of the packing at half its height.
std::size_t mid_height(const TomlValue& probe, const Scene& scene) {
  if (!scene.packed) probe.reject("a network without coordinates has no mid-height; give the id of a node");
  const auto& packing = scene.packed->packing;
  const Bounds box = surface_bounds(packing);
  const Vec3 middle = 0.5 * (box.min + box.max);
  std::size_t nearest = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const double distance = norm(packing.centre[k] - middle);
    if (scene.fields.front().roles[k] == NodeRole::free && distance < smallest) {
      smallest = distance;
      nearest = k;
    }
  }
  return nearest;
}

Probe by_id(const TomlValue& value, const Scene& scene) {
  const auto& ids = scene.fields.front().graph.id;
  const auto found = std::find(ids.begin(), ids.end(), value.integer());
  if (found == ids.end()) value.reject("it must be the id of a node");
  const auto node = static_cast<std::int32_t>(found - ids.begin());
  for (const auto& field : scene.fields)
    for (const auto& algebraic : field.algebraic)
      if (algebraic.node == node)
        value.reject(
            "the node has capacity 0 and is no part of the state; probe one of its neighbours, or give it a "
            "small "
            "capacity");
  return {std::to_string(*found), *found, node};
}

Probe read_probe(const TomlValue& value, const Scene& scene) {
  if (!value.is_string()) return by_id(value, scene);
  if (value.string() != "mid-height") value.reject("it must be \"mid-height\", an id, or a list of these");
  const std::size_t node = mid_height(value, scene);
  return {"mid-height", scene.fields.front().graph.id[node], static_cast<std::int32_t>(node)};
}

}  // namespace

std::vector<Probe> read_probes(const TomlValue& probe, const Scene& scene) {
  if (!probe.is_array()) return {read_probe(probe, scene)};
  std::vector<Probe> probes;
  for (const auto& value : probe.array()) {
    probes.push_back(read_probe(value, scene));
    const auto same = [&](const Probe& other) { return other.label == probes.back().label; };
    if (std::count_if(probes.begin(), probes.end(), same) > 1) value.reject("it stands twice; keep one");
  }
  return probes;
}

}  // namespace superstep
