#pragma once
/// Scenes of which nobody has the whole: every process has the layers that it owns, and makes or reads them
/// itself.
///
/// Nodes are numbered layer by layer, rows are the free nodes in that order, and blocks are consecutive cuts
/// of it, so that a halo is a layer on either side. The rows of a process come out as they would be cut from
/// the whole scene.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "case/layers/layer_reader.hpp"
#include "case/parts/own_nodes.hpp"
#include "case/scene.hpp"
#include "parallel/communicator.hpp"

namespace superstep {

/// What is known of all nodes, and which of them a process has.
class LayeredNodes final : public OwnNodes {
 public:
  explicit LayeredNodes(LayerReader reader) : reader_(std::move(reader)) {}
  /// Those of a scene that was built in layers.
  [[nodiscard]] static LayeredNodes& of(const Scene& scene) {
    return dynamic_cast<LayeredNodes&>(*scene.own_nodes);
  }

  [[nodiscard]] std::int64_t nodes() const override { return source().nodes(); }
  [[nodiscard]] bool are_spheres() const override { return true; }
  void show(const std::function<void(const ShownNode&)>& each) override;

  [[nodiscard]] LayerReader& reader() noexcept { return reader_; }
  [[nodiscard]] LayerSource& source() noexcept { return reader_.source(); }
  [[nodiscard]] const LayerSource& source() const noexcept { return reader_.source(); }

  /// Rows before each layer, and in all [layers + 1].
  std::vector<std::int64_t> rows_before;
  [[nodiscard]] std::int64_t rows() const noexcept { return rows_before.back(); }
  /// Layers that the nodes which are here stand in, and one more on either side: those that their contacts
  /// reach.
  [[nodiscard]] std::pair<std::int64_t, std::int64_t> layers_around() const {
    if (begin == end) return {0, 0};
    return {std::max<std::int64_t>(0, source().layer_of_node(begin) - 1),
            std::min(source().layers(), source().layer_of_node(end - 1) + 2)};
  }

  /// Calls each(first layer, last layer) for stretches of the layers that the nodes which are here stand in,
  /// none of them so long that it would matter beside the rows.
  template <class Each>
  void for_stretches(const Each& each) const {
    if (begin == end) return;
    const std::int64_t last = source().layer_of_node(end - 1) + 1, step = stretch();
    for (std::int64_t layer = source().layer_of_node(begin); layer < last; layer += step)
      each(layer, std::min(layer + step, last));
  }
  /// Layers that are read at a time.
  [[nodiscard]] std::int64_t stretch() const noexcept {
    // Some 0.8 kB a sphere while they are read, two layers more each time: a small part of all, and not so
    // small that most of the work would be these two.
    constexpr std::int64_t spheres = 1'000'000, part = 48, fewest = 4;
    const std::int64_t layers = source().layers(),
                       layer = std::max<std::int64_t>(1, source().nodes() / layers);
    return std::max<std::int64_t>(1, std::min(std::max(layers / part, fewest), spheres / layer));
  }

 private:
  LayerReader reader_;
};

/// Whether processes can share a case like that: its packing has layers, their spheres have one linear
/// temperature field of one material, and nothing follows a table of time. `why_not` is set where the case
/// asks for layers and cannot have them. Throws InputError for what is wrong anyway.
[[nodiscard]] bool can_be_layered(const TomlTable& root, std::string& why_not);

/// Collective: every process reads the same case. The scene's right-hand side and its initial state are those
/// of the rows that are here, its graph holds the probed nodes alone. Throws InputError, on all processes the
/// same.
[[nodiscard]] Scene build_in_layers(TomlTable root, Communicator& among);

}  // namespace superstep
