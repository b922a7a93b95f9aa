#include "dynamics/neighbour_list.hpp"

#include <algorithm>
#include <cmath>

namespace superstep::dynamics {

bool NeighbourList::stale(std::span<const Vec3> position) const noexcept {
  if (builds_ == 0) return true;
  const double limit = 0.25 * skin_ * skin_;
  double farthest = 0;
  for (std::size_t i = 0; i < position.size(); ++i) {
    const Vec3 moved = position[i] - listed_[i];
    farthest = std::max(farthest, dot(moved, moved));
  }
  return farthest > limit;
}

bool NeighbourList::update(std::span<const Vec3> position, std::span<const double> radius) {
  if (!stale(position)) return false;
  // A runaway position would ask for absurdly many cells; the forces on it are not finite either.
  for (const Vec3& point : position)
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) return false;
  pairs_ = near_pairs(position, radius, skin_);
  listed_.assign(position.begin(), position.end());
  ++builds_;
  return true;
}

}  // namespace superstep::dynamics
