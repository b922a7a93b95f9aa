#pragma once
/// Scenes of which nobody has the whole: every process makes the layers of a lattice that it owns.
///
/// Nodes are numbered layer by layer, rows are the free nodes in that order, and blocks are consecutive cuts
/// of it, so that a halo is a layer on either side. The rows of a process come out as they would be cut from
/// the whole scene.

#include <cstdint>
#include <vector>

#include "case/layers/layer_reader.hpp"
#include "case/scene.hpp"
#include "parallel/communicator.hpp"

namespace superstep {

/// What is known of all nodes, and which of them a process has.
class LayeredNodes {
 public:
  explicit LayeredNodes(LayerReader reader) : reader_(std::move(reader)) {}

  [[nodiscard]] LayerReader& reader() noexcept { return reader_; }
  [[nodiscard]] const Lattice& lattice() const noexcept { return reader_.lattice(); }

  /// Rows before each layer, and in all [layers + 1].
  std::vector<std::int64_t> rows_before;
  std::int64_t begin = 0, end = 0;  ///< nodes that are here
  std::int64_t edges = 0;           ///< of the whole scene

  [[nodiscard]] std::int64_t rows() const noexcept { return rows_before.back(); }
  [[nodiscard]] std::int64_t layer_of_node(std::int64_t node) const noexcept {
    return node / lattice().layer();
  }

  /// Calls each(first layer, last layer) for stretches of the layers that the nodes which are here stand in,
  /// none of them so long that it would matter beside the rows.
  template <class Each>
  void for_stretches(const Each& each) const {
    if (begin == end) return;
    const std::int64_t last = layer_of_node(end - 1) + 1, step = stretch();
    for (std::int64_t layer = layer_of_node(begin); layer < last; layer += step)
      each(layer, std::min(layer + step, last));
  }
  /// Layers that are read at a time.
  [[nodiscard]] std::int64_t stretch() const noexcept {
    // Some 0.8 kB a sphere while they are read, two layers more each time: a small part of all, and not too
    // small.
    constexpr std::int64_t spheres = 1'000'000, part = 48;
    return std::max<std::int64_t>(1, std::min(lattice().cells[2] / part, spheres / lattice().layer()));
  }

 private:
  LayerReader reader_;
};

/// Whether processes can share a case like that: a lattice whose spheres touch their neighbours, one linear
/// temperature field of one material, and nothing that follows a table of time. Throws InputError for what is
/// wrong anyway.
[[nodiscard]] bool can_be_layered(const TomlTable& root);

/// Collective: every process reads the same case. The scene's right-hand side and its initial state are those
/// of the rows that are here, its graph holds the probed nodes alone. Throws InputError, on all processes the
/// same.
[[nodiscard]] Scene build_in_layers(TomlTable root, Communicator& among);

}  // namespace superstep
