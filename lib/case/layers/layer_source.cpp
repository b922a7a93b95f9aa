#include "case/layers/layer_source.hpp"

#include "case/layers/lattice_source.hpp"
#include "case/layers/table_source.hpp"

namespace superstep {

std::int64_t LayerSource::layer_of_node(std::int64_t node) const {
  std::int64_t low = 0, high = layers();  // nodes_before(low) <= node < nodes_before(high)
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (nodes_before(middle) <= node ? low : high) = middle;
  }
  return low;
}

std::unique_ptr<LayerSource> find_layer_source(TomlTable& packing, std::string& why_not) {
  if (auto lattice = find_lattice_source(packing)) return lattice;
  return find_table_source(packing, why_not);
}

}  // namespace superstep
