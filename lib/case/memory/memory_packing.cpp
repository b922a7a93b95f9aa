#include "case/memory/memory_packing.hpp"

#include <fmt/format.h>

#include "case/memory/array_checks.hpp"
#include "core/error.hpp"
#include "packing/formats/packing_builder.hpp"
#include "packing/read.hpp"
#include "packing/units.hpp"

namespace superstep {
namespace {

double unit_of(const PackingOptions& options, const std::string& name) {
  if (options.units != "auto" || options.format != "auto" || !options.atom_style.empty() ||
      !options.columns.empty())
    throw InputError(
        fmt::format("{}: [packing] units, format, atom_style and columns say how a file is read, and the "
                    "particles are in memory; leave them out, and give length_unit",
                    name));
  return options.length_unit.value_or(1.0);
}

}  // namespace

Packing packing_of(const SphereArrays& arrays, const std::string& name, const PackingOptions& options) {
  const double unit = unit_of(options, name);
  const std::size_t n = arrays.radii.size();
  if (n == 0) throw InputError(fmt::format("{}: radii is empty; at least one particle is needed", name));
  require_length(name, "centres", arrays.centres.size(), 3 * n, "three coordinates for each radius");
  require_finite(name, "centres", arrays.centres);
  require_finite(name, "radii", arrays.radii);
  if (!arrays.ids.empty()) require_length(name, "ids", arrays.ids.size(), n, "one for each radius");
  if (!arrays.materials.empty())
    require_length(name, "materials", arrays.materials.size(), n, "one for each radius");

  PackingBuilder builder(name, unit, "particle");
  for (std::size_t k = 0; k < n; ++k) {
    const auto x = arrays.centres.subspan(3 * k, 3);
    builder.add(k, arrays.ids.empty() ? static_cast<std::int64_t>(k) : arrays.ids[k], {x[0], x[1], x[2]},
                arrays.radii[k]);
    if (!arrays.materials.empty()) builder.set_material(arrays.materials[k]);
  }
  Packing packing = builder.finish();
  packing.length_unit = unit;
  packing.format = "arrays in memory";
  packing.notes.push_back(fmt::format("lengths are in {}", length_unit_name(unit)));
  for (const auto& attribute : arrays.attributes) {
    require_length(name, attribute.name, attribute.value.size(), n, "one for each radius");
    require_finite(name, attribute.name, attribute.value);
    packing.attributes.push_back(attribute);
  }
  apply_box(options, name, packing);
  return packing;
}

}  // namespace superstep
