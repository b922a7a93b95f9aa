#include "packing/grid.hpp"

#include "core/random.hpp"

namespace superstep {
namespace {

std::int32_t draw_material(const GridSettings& settings, Random& random) {
  const std::size_t n = settings.materials.size();
  if (n < 2) return 0;
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) sum += settings.shares.empty() ? 1 : settings.shares[k];
  double left = random.uniform() * sum;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    left -= settings.shares.empty() ? 1 : settings.shares[k];
    if (left < 0) return static_cast<std::int32_t>(k);
  }
  return static_cast<std::int32_t>(n - 1);
}

}  // namespace

Packing grid_packing(const GridSettings& settings) {
  std::size_t side = 2;
  while ((side + 1) * (side + 1) * (side + 1) <= settings.count) ++side;
  Packing packing;
  packing.material_names = settings.materials;
  Random random(settings.seed);
  const auto shaken = [&](std::size_t cell) {
    const double offset = settings.jitter * (2 * random.uniform() - 1);
    return settings.spacing * (static_cast<double>(cell) + offset);
  };
  for (std::size_t k = 0; k < side * side * side; ++k) {
    packing.id.push_back(static_cast<std::int64_t>(k));
    const double x = shaken(k % side), y = shaken(k / side % side), z = shaken(k / (side * side));
    packing.centre.push_back({x, y, z});
    const double diameter = settings.smallest + (settings.largest - settings.smallest) * random.uniform();
    packing.radius.push_back(0.5 * diameter);
    packing.material.push_back(draw_material(settings, random));
  }
  return packing;
}

}  // namespace superstep
