#include "case/layers/layer_reader.hpp"

#include <utility>

#include "case/materials.hpp"
#include "case/packed/packing_options.hpp"
#include "case/packed/read_lattice.hpp"
#include "case/read_field.hpp"

namespace superstep {

LayerReader::LayerReader(TomlTable root) : root_(std::move(root)) {
  read_head(root_, head_);
  TomlTable packing = *root_.table("packing");
  unit_ = read_packing_options(packing).length_unit.value_or(1.0);
  place_ = packing.require("generator", "it names the lattice").where();
  lattice_ = read_lattice(packing, unit_);
}

ReadLayers LayerReader::read(std::int64_t first, std::int64_t last, bool contacts) {
  PackingInput input;
  input.unit = unit_;
  input.t_end = head_.t_end;
  input.scene.length_unit = unit_;
  input.selections = &selections_;
  input.scene.packing = lattice_layers(lattice_, first, last);
  if (contacts) read_contact_table(root_, place_, input);
  Materials materials(root_, input.scene.packing);
  TomlTable thermal = *root_.table("thermal");
  FieldScene field = read_field(thermal_kind(), thermal, input, materials, false);
  return {std::move(input.scene), std::move(field)};
}

}  // namespace superstep
