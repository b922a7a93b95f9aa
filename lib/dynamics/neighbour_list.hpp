#pragma once
/// Pairs that may touch soon: a Verlet list with a skin over the cell bins of `near_pairs`.

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec3.hpp"
#include "packing/near_pairs.hpp"

namespace superstep::dynamics {

class NeighbourList {
 public:
  /// skin [m] > 0: the list holds every pair nearer than r_i + r_j + skin, and stays valid until some
  /// particle has moved by half the skin.
  explicit NeighbourList(double skin) : skin_(skin) {}

  /// Makes the list valid for these positions; true when it had to be built anew. O(n). A non-finite position
  /// leaves the list as it is: the caller finds the particle by its forces.
  bool update(std::span<const Vec3> position, std::span<const double> radius);

  /// Sorted by (i, j), i < j.
  [[nodiscard]] std::span<const NearPair> pairs() const noexcept { return pairs_; }
  [[nodiscard]] std::uint64_t builds() const noexcept { return builds_; }

 private:
  [[nodiscard]] bool stale(std::span<const Vec3> position) const noexcept;

  double skin_;
  std::vector<NearPair> pairs_;
  std::vector<Vec3> listed_;  // positions when the list was built
  std::uint64_t builds_ = 0;
};

}  // namespace superstep::dynamics
