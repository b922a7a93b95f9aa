#pragma once
/// Geometry of all pair contacts at one instant.

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/laws/bond_law.hpp"
#include "dynamics/neighbour_list.hpp"
#include "dynamics/particles.hpp"

namespace superstep::dynamics {

/// A pair that acts on each other: in contact, or held together by a bond.
struct ContactPoint {
  std::int32_t i, j;
  Vec3 normal;        ///< from i to j
  double strain;      ///< E < 0 in contact
  double area;        ///< A_c [m2]; of the bond where the pair has come apart
  double distance;    ///< of the centres [m]
  double radius_sum;  ///< m
  bool bonded;
};

/// Follows the particles: bonds and the list of candidate pairs live on from one instant to the next.
class ContactPoints {
 public:
  ContactPoints(const BondLaw& law, double skin, double largest_radius)
      : law_(law), list_(skin, 2 * largest_radius * law.reach()) {}

  /// Contacts of these positions, sorted by (i, j), whatever the list behind them: results do not depend on
  /// when it was built.
  void place(std::span<const Vec3> position, std::span<const double> radius);
  /// Forms and breaks bonds by the contacts at hand: once a step, never inside its iterations, so that a pair
  /// at the threshold cannot keep an iteration from converging.
  void update_bonds();
  void set_bonds(std::span<const Bond> bonds);

  [[nodiscard]] std::span<const ContactPoint> points() const noexcept { return points_; }
  /// Sorted by (i, j).
  [[nodiscard]] std::span<const Bond> bonds() const noexcept { return bonds_; }
  [[nodiscard]] const NeighbourList& list() const noexcept { return list_; }
  /// Pairs with strain < 0.
  [[nodiscard]] std::size_t touching() const noexcept { return touching_; }

 private:
  void spread_bonds();

  BondLaw law_;
  NeighbourList list_;
  std::vector<double> bond_area_;     // of each pair of the list; 0 = none [m2]
  std::vector<std::size_t> pair_of_;  // [points] position in the list
  std::vector<ContactPoint> points_;
  std::vector<Bond> bonds_;
  std::size_t touching_ = 0;
};

}  // namespace superstep::dynamics
