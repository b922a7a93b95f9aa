#include "packing/parts/layers.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "parallel/exact_sum.hpp"

namespace superstep {
namespace {

template <class Value>
void reorder(const std::vector<std::size_t>& order, std::vector<Value>& values) {
  if (values.empty()) return;
  std::vector<Value> sorted;
  sorted.reserve(values.size());
  for (const auto k : order) sorted.push_back(values[k]);
  values = std::move(sorted);
}

Bounds bounds_of_centres(const Packing& packing) {
  Bounds box{packing.centre.front(), packing.centre.front()};
  for (const Vec3 c : packing.centre) box.take(c, c);
  return box;
}

/// Of all radii [m], the same in whatever order they stand.
double mean_diameter_of(const Packing& packing) {
  ExactSum sum;
  for (const double r : packing.radius) sum.add(r);
  return mean_diameter(sum.value(), packing.size());
}

}  // namespace

PackingLayers::PackingLayers(const Bounds& centres, double largest_radius, std::int64_t particles)
    : low_(centres.min) {
  // Spheres that touch are nearer than that, also when the number of their layer is rounded.
  constexpr double room_for_rounding = 1 + 1e-6;
  const Vec3 side = centres.max - centres.min;
  std::stable_sort(axes_.begin(), axes_.end(),
                   [&](char a, char b) { return component(side, a) > component(side, b); });
  thickness_ =
      std::max(2 * largest_radius * room_for_rounding,
               component(side, axes_[0]) / static_cast<double>(std::max<std::int64_t>(1, particles)));
  for (std::size_t k = 0; k < cells_.size(); ++k)
    cells_[k] = 1 + static_cast<std::int64_t>(component(side, axes_[k]) / thickness_);
  cells_[0] = std::min(cells_[0], std::max<std::int64_t>(1, particles));
}

LayerPlace PackingLayers::place_of(Vec3 centre, std::int64_t id) const noexcept {
  const auto cell = [&](std::size_t k) {
    return std::min(static_cast<std::int64_t>(component(centre - low_, axes_[k]) / thickness_),
                    cells_[k] - 1);
  };
  return {cell(0), cell(1), cell(2), id};
}

double PackingLayers::distance(std::int64_t first, std::int64_t last, Vec3 point) const noexcept {
  constexpr double rounding = 1e-6;  // of a thickness, by which a centre may be beyond the side of its layer
  const double place = component(point - low_, axes_[0]) / thickness_;
  const double below = static_cast<double>(first) - place, above = place - static_cast<double>(last);
  return thickness_ * std::max({0.0, below - rounding, last == count() ? 0.0 : above - rounding});
}

void stand_in_layers(Packing& packing) {
  const PackingLayers layers(bounds_of_centres(packing),
                             *std::max_element(packing.radius.begin(), packing.radius.end()),
                             static_cast<std::int64_t>(packing.size()));
  std::vector<LayerPlace> place(packing.size());
  for (std::size_t k = 0; k < place.size(); ++k) place[k] = layers.place_of(packing.centre[k], packing.id[k]);
  std::vector<std::size_t> order(packing.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place[a] < place[b]; });
  reorder(order, packing.id);
  reorder(order, packing.centre);
  reorder(order, packing.radius);
  reorder(order, packing.material);
  for (auto& attribute : packing.attributes) reorder(order, attribute.value);
  packing.in_order = true;
  packing.mean_diameter = mean_diameter_of(packing);
}

}  // namespace superstep
