#include <fmt/format.h>

#include <iterator>

#include "packing/formats/stated.hpp"
#include "packing/read.hpp"

namespace superstep {

std::string packing_csv(const Packing& packing) {
  const bool has_materials = !packing.material_names.empty();
  fmt::memory_buffer text;
  auto out = std::back_inserter(text);
  fmt::format_to(out, "# length_unit = \"m\"\n{}id,x,y,z,radius{}",
                 packing.cell ? cell_comment(*packing.cell) : "", has_materials ? ",material" : "");
  for (const auto& attribute : packing.attributes) fmt::format_to(out, ",\"{}\"", attribute.name);
  text.push_back('\n');
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const auto [x, y, z] = packing.centre[k];
    // "{}" writes the shortest text that reads back as the same double.
    fmt::format_to(out, "{},{},{},{},{}", packing.id[k], x, y, z, packing.radius[k]);
    if (has_materials)
      fmt::format_to(out, ",{}", packing.material_names[static_cast<std::size_t>(packing.material[k])]);
    for (const auto& attribute : packing.attributes) fmt::format_to(out, ",{}", attribute.value[k]);
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

}  // namespace superstep
