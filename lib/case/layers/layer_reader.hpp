#pragma once
/// Some layers of a scene and what the case says of their spheres, read as if they were a packing of their
/// own.

#include <memory>

#include "case/layers/layer_source.hpp"
#include "case/read_packing_scene.hpp"
#include "case/scene.hpp"
#include "core/text/toml.hpp"

namespace superstep {

struct ReadLayers {
  PackingScene packed;  ///< spheres, and their contacts where they were asked for
  FieldScene field;     ///< its temperature; without edges where contacts were not asked for
  std::int64_t first_node = 0;
};

class LayerReader {
 public:
  /// Throws InputError.
  LayerReader(TomlTable root, std::unique_ptr<LayerSource> source);

  [[nodiscard]] const CaseHead& head() const noexcept { return head_; }
  [[nodiscard]] LayerSource& source() noexcept { return *source_; }
  [[nodiscard]] const LayerSource& source() const noexcept { return *source_; }
  [[nodiscard]] TomlTable& root() noexcept { return root_; }

  /// Layers [first, last), which the source has here. Throws InputError; a selection may hold nobody of them.
  [[nodiscard]] ReadLayers read(std::int64_t first, std::int64_t last, bool contacts);
  /// The source's sample, of which selections say nothing.
  [[nodiscard]] ReadLayers read_sample(bool contacts);
  /// Selections of all that was read, by their place in the case, and whether they held anybody.
  [[nodiscard]] const SelectionLog& selections() const noexcept { return logs_.selections; }
  /// What feeds particles, and whether it feeds a free one.
  [[nodiscard]] const SelectionLog& fed() const noexcept { return logs_.fed; }

 private:
  struct Logs {
    SelectionLog selections, fed;
  };
  [[nodiscard]] ReadLayers read(Packing packing, bool contacts, Logs& logs);

  TomlTable root_;
  CaseHead head_;
  std::unique_ptr<LayerSource> source_;
  Logs logs_;
};

}  // namespace superstep
