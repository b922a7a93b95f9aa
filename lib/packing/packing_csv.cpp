#include <fmt/format.h>

#include "core/text/append.hpp"
#include "packing/formats/stated.hpp"
#include "packing/read.hpp"

namespace superstep {

std::string packing_csv_head(const Packing& packing) {
  std::string text = fmt::format("# length_unit = \"m\"\n{}id,x,y,z,radius{}",
                                 packing.cell ? cell_comment(*packing.cell) : "",
                                 packing.material_names.empty() ? "" : ",material");
  for (const auto& attribute : packing.attributes) text += fmt::format(",\"{}\"", attribute.name);
  return text + "\n";
}

std::string packing_csv_rows(const Packing& packing) {
  std::string text;
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const auto [x, y, z] = packing.centre[k];
    // "{}" writes the shortest text that reads back as the same double.
    append(text, "{},{},{},{},{}", packing.id[k], x, y, z, packing.radius[k]);
    if (!packing.material_names.empty())
      append(text, ",{}", packing.material_names[static_cast<std::size_t>(packing.material[k])]);
    for (const auto& attribute : packing.attributes) append(text, ",{}", attribute.value[k]);
    text.push_back('\n');
  }
  return text;
}

std::string packing_csv(const Packing& packing) {
  return packing_csv_head(packing) + packing_csv_rows(packing);
}

}  // namespace superstep
