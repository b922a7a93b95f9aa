#include "packing/packing.hpp"

#include <algorithm>
#include <numbers>

#include "core/text/bracketed_unit.hpp"

namespace superstep {

const PackingAttribute* find_attribute(const Packing& packing, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& attribute : packing.attributes) names.push_back(attribute.name);
  const auto place = place_of_name(names, name, packing.place);
  return place ? &packing.attributes[*place] : nullptr;
}

Bounds surface_bounds(const Packing& packing) {
  if (packing.part_of) return packing.part_of->bounds;
  const auto corner = [&](std::size_t k, double sign) {
    const double r = sign * packing.radius[k];
    return packing.centre[k] + Vec3{r, r, r};
  };
  Bounds box{corner(0, -1.0), corner(0, 1.0)};
  for (std::size_t k = 1; k < packing.size(); ++k) box.take(corner(k, -1.0), corner(k, 1.0));
  return box;
}

double sphere_volume(const Packing& packing) {
  double cubes = 0;
  for (const double r : packing.radius) cubes += r * r * r;
  return 4.0 / 3.0 * std::numbers::pi * cubes;
}

}  // namespace superstep
