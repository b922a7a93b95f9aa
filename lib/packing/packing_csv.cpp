#include <fmt/format.h>

#include <string>
#include <vector>

#include "core/text/append.hpp"
#include "packing/formats/stated.hpp"
#include "packing/read.hpp"

namespace superstep {
namespace {

/// A name as a cell: between quotes where a reader would find a delimiter or a quote in it.
std::string cell_of(const std::string& name) {
  if (name.find_first_of(",;\t\"") == std::string::npos) return name;
  std::string out = "\"";
  for (const char c : name) out.append(c == '"' ? 2 : 1, c);
  return out + '"';
}

}  // namespace

std::string packing_csv_head(const Packing& packing) {
  std::string text = fmt::format("# length_unit = \"m\"\n{}id,x,y,z,radius{}",
                                 packing.cell ? cell_comment(*packing.cell) : "",
                                 packing.material_names.empty() ? "" : ",material");
  for (const auto& attribute : packing.attributes) text += fmt::format(",\"{}\"", attribute.name);
  return text + "\n";
}

std::string packing_csv_rows(const Packing& packing) {
  std::vector<std::string> materials;
  for (const auto& name : packing.material_names) materials.push_back(cell_of(name));
  std::string text;
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const auto [x, y, z] = packing.centre[k];
    // "{}" writes the shortest text that reads back as the same double.
    append(text, "{},{},{},{},{}", packing.id[k], x, y, z, packing.radius[k]);
    if (!materials.empty()) append(text, ",{}", materials[static_cast<std::size_t>(packing.material[k])]);
    for (const auto& attribute : packing.attributes) append(text, ",{}", attribute.value[k]);
    text.push_back('\n');
  }
  return text;
}

std::string packing_csv(const Packing& packing) {
  return packing_csv_head(packing) + packing_csv_rows(packing);
}

}  // namespace superstep
