#include "packing/parts/layers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/index.hpp"
#include "parallel/exact_sum.hpp"

namespace superstep {
namespace {

double along(Vec3 point, std::size_t axis) noexcept {
  return axis == 0 ? point.x : axis == 1 ? point.y : point.z;
}

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
  for (const Vec3 c : packing.centre) {
    box.min = {std::min(box.min.x, c.x), std::min(box.min.y, c.y), std::min(box.min.z, c.z)};
    box.max = {std::max(box.max.x, c.x), std::max(box.max.y, c.y), std::max(box.max.z, c.z)};
  }
  return box;
}

}  // namespace

PackingLayers::PackingLayers(const Bounds& centres, double largest_radius, std::int64_t particles)
    : low_(centres.min) {
  // Spheres that touch are nearer than that, also when the number of their layer is rounded.
  constexpr double room_for_rounding = 1 + 1e-6;
  const Vec3 side = centres.max - centres.min;
  std::stable_sort(axes_.begin(), axes_.end(),
                   [&](std::size_t a, std::size_t b) { return along(side, a) > along(side, b); });
  thickness_ = std::max(2 * largest_radius * room_for_rounding,
                        along(side, axes_[0]) / static_cast<double>(std::max<std::int64_t>(1, particles)));
  for (std::size_t axis = 0; axis < cells_.size(); ++axis)
    cells_[axis] = 1 + static_cast<std::int64_t>(along(side, axis) / thickness_);
  cells_[axes_[0]] = std::min(cells_[axes_[0]], std::max<std::int64_t>(1, particles));
}

LayerPlace PackingLayers::place_of(Vec3 centre, std::int64_t id) const noexcept {
  const auto cell = [&](std::size_t axis) {
    const auto k = static_cast<std::int64_t>((along(centre, axis) - along(low_, axis)) / thickness_);
    return std::min(k, cells_[axis] - 1);
  };
  return {cell(axes_[0]), cell(axes_[1]), cell(axes_[2]), id};
}

double PackingLayers::distance(std::int64_t first, std::int64_t last, Vec3 point) const noexcept {
  constexpr double rounding = 1e-6;  // of a thickness, by which a centre may be beyond the side of its layer
  const double place = (along(point, axes_[0]) - along(low_, axes_[0])) / thickness_;
  const double below = static_cast<double>(first) - place, above = place - static_cast<double>(last);
  return thickness_ * std::max({0.0, below - rounding, last == count() ? 0.0 : above - rounding});
}

double exact_mean_diameter(const Packing& packing) {
  ExactSum sum;
  for (const double r : packing.radius) sum.add(r);
  return 2 * sum.value() / static_cast<double>(packing.size());
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
  packing.mean_diameter = exact_mean_diameter(packing);
}

}  // namespace superstep
