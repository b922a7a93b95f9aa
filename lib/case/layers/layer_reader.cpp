#include "case/layers/layer_reader.hpp"

#include <utility>

#include "case/materials.hpp"
#include "case/read_field.hpp"

namespace superstep {

LayerReader::LayerReader(TomlTable root, std::unique_ptr<LayerSource> source)
    : root_(std::move(root)), source_(std::move(source)) {
  read_head(root_, head_);
}

ReadLayers LayerReader::read(std::int64_t first, std::int64_t last, bool contacts) {
  ReadLayers layers = read(source_->packing(first, last), contacts, logs_);
  layers.first_node = source_->nodes_before(first);
  return layers;
}

ReadLayers LayerReader::read_sample(bool contacts) {
  Logs of_nobody;
  return read(source_->sample(), contacts, of_nobody);
}

ReadLayers LayerReader::read(Packing packing, bool contacts, Logs& logs) {
  PackingInput input;
  input.unit = source_->length_unit();
  input.t_end = head_.t_end;
  input.scene.length_unit = input.unit;
  input.selections = &logs.selections;
  input.fed = &logs.fed;
  input.scene.packing = std::move(packing);
  if (contacts) read_contact_table(root_, source_->place(), input);
  Materials materials(root_, input.scene.packing);
  TomlTable thermal = *root_.table("thermal");
  FieldScene field = read_field(thermal_kind(), thermal, input, materials, false);
  return {std::move(input.scene), std::move(field)};
}

}  // namespace superstep
