#include "case/probe.hpp"

#include <algorithm>

#include "core/text/ids_in_words.hpp"

namespace superstep {
namespace {

/// The free particle nearest to the axis of the packing at half its height.
std::size_t mid_height(const TomlValue& probe, const Scene& scene) {
  if (!scene.packed) probe.reject("a network without coordinates has no mid-height; give the id of a node");
  const auto& packing = scene.packed->packing;
  MidHeight found(surface_bounds(packing));
  for (std::size_t k = 0; k < packing.size(); ++k)
    if (scene.fields.front().roles[k] == NodeRole::free)
      found.look_at(packing.centre[k], static_cast<std::int64_t>(k));
  return static_cast<std::size_t>(found.nearest());
}

Probe by_id(const TomlValue& value, const Scene& scene) {
  const auto& ids = scene.fields.front().graph.id;
  const auto found = std::find(ids.begin(), ids.end(), value.integer());
  if (found == ids.end()) value.reject("it must be the id of a node; " + ids_in_words(ids));
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

}  // namespace

std::vector<Probe> read_probes(const TomlValue& probe, const ProbeFinder& find) {
  const auto read = [&](const TomlValue& value) {
    if (!value.is_string()) return find.by_id(value);
    if (value.string() != "mid-height") value.reject("it must be \"mid-height\", an id, or a list of these");
    return find.at_mid_height(value);
  };
  if (!probe.is_array()) return {read(probe)};
  std::vector<Probe> probes;
  for (const auto& value : probe.array()) {
    probes.push_back(read(value));
    const auto same = [&](const Probe& other) { return other.label == probes.back().label; };
    if (std::count_if(probes.begin(), probes.end(), same) > 1) value.reject("it stands twice; keep one");
  }
  return probes;
}

std::vector<Probe> read_probes(const TomlValue& probe, const Scene& scene) {
  const auto at_mid_height = [&](const TomlValue& value) {
    const std::size_t node = mid_height(value, scene);
    return Probe{"mid-height", scene.fields.front().graph.id[node], static_cast<std::int32_t>(node)};
  };
  return read_probes(probe, {.by_id = [&](const TomlValue& value) { return by_id(value, scene); },
                             .at_mid_height = at_mid_height});
}

}  // namespace superstep
