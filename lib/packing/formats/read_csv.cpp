#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text/csv.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/packing_builder.hpp"

namespace superstep {

Packing read_csv(const std::string& path, double unit) {
  enum Column : std::size_t { x, y, z, radius, id, material };
  CsvReader rows(path, {"x", "y", "z", "radius"}, {"id", "material"});
  PackingBuilder builder(path, unit);
  while (rows.next()) {
    const auto number = rows.has(id) ? rows.integer(id) : static_cast<std::int64_t>(builder.size());
    builder.add(rows.line(), number, {rows.number(x), rows.number(y), rows.number(z)}, rows.number(radius));
    if (!rows.has(material)) continue;
    if (rows.text(material).empty())
      throw InputError(fmt::format(
          "{}: column 'material' is ''; it must name a material in every row, or be left out", rows.where()));
    builder.set_material(rows.text(material));
  }
  return builder.finish();
}

}  // namespace superstep
