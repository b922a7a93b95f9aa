#pragma once
/// Some layers of a lattice and what the case says of their spheres, read as if they were a packing of their
/// own.

#include <string>

#include "case/read_packing_scene.hpp"
#include "case/scene.hpp"
#include "core/text/toml.hpp"
#include "packing/lattice.hpp"

namespace superstep {

struct ReadLayers {
  PackingScene packed;  ///< spheres, and their contacts where they were asked for
  FieldScene field;     ///< its temperature; without edges where contacts were not asked for

  [[nodiscard]] std::int64_t first_node() const noexcept { return packed.packing.id.front(); }
};

class LayerReader {
 public:
  /// Of a case whose [packing] is a lattice. Throws InputError.
  explicit LayerReader(TomlTable root);

  [[nodiscard]] const CaseHead& head() const noexcept { return head_; }
  [[nodiscard]] const Lattice& lattice() const noexcept { return lattice_; }
  [[nodiscard]] TomlTable& root() noexcept { return root_; }

  /// Layers [first, last). Throws InputError; a selection may hold nobody of them.
  [[nodiscard]] ReadLayers read(std::int64_t first, std::int64_t last, bool contacts);
  /// Selections of all that was read, by their place in the case, and whether they held anybody.
  [[nodiscard]] const SelectionLog& selections() const noexcept { return selections_; }

 private:
  TomlTable root_;
  CaseHead head_;
  double unit_ = 1;  // m per length of the case
  Lattice lattice_;
  std::string place_;  // of the lattice in the case
  SelectionLog selections_;
};

}  // namespace superstep
