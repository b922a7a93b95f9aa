#pragma once
/// Geometry of all pair contacts at one instant.

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/contacts/bond_registry.hpp"
#include "dynamics/contacts/contact_table.hpp"
#include "dynamics/neighbour_list.hpp"
#include "dynamics/particles.hpp"

namespace superstep::dynamics {

/// A pair that acts on each other: in contact, or held together by a bond.
struct ContactPoint {
  std::int32_t i, j;
  Vec3 normal;          ///< from i to j
  double strain;        ///< E < 0 in contact
  double area;          ///< that conducts: of the contact, or of the bond where that is larger [m2]
  double distance;      ///< of the centres [m]
  double radius_sum;    ///< m
  double conductivity;  ///< of heat [W/(m K)]
  bool bonded;
};

/// Follows the particles: bonds and the lists of candidate pairs live on from one instant to the next.
///
///   list   every pair nearer than the skin; found anew when somebody has moved by half of it
///   table  those of it nearer than an eighth of the skin, and all bonded pairs; picked anew when somebody
///          has moved by half of that
class ContactPoints {
 public:
  /// Keeps a reference to the particles.
  ///   conductivity  of heat, where the particles do not say [W/(m K)]
  ContactPoints(const BondLaw& law, double skin, const Particles& particles, double conductivity = 0);

  /// Contacts of these positions, sorted by (i, j), whatever the lists behind them: results do not depend on
  /// when they were built. Bonds do not act yet.
  void place(std::span<const Vec3> position);
  /// Takes the bonds to this instant of the step.
  void act(const BondSurroundings& around);
  /// What bonds have become at the instant last placed stays: they form and break, once a step, never inside
  /// its iterations, so that a pair at the threshold cannot keep an iteration from converging.
  void update_bonds();
  /// Growth rates of this instant are those that the next step begins with.
  void begin_step();
  void set_bonds(std::span<const Bond> bonds);

  /// Pairs of the table that touch or are bonded.
  [[nodiscard]] std::span<const ContactPoint> points() const;
  [[nodiscard]] const ContactTable& table() const noexcept { return table_; }
  [[nodiscard]] const Incidence& incidence() const;
  [[nodiscard]] const BondArrays& bonded() const noexcept { return arrays_; }
  /// Sorted by (i, j).
  [[nodiscard]] std::span<const Bond> bonds() const noexcept { return bonds_; }
  [[nodiscard]] const NeighbourList& list() const noexcept { return list_; }
  /// Pairs with strain < 0.
  [[nodiscard]] std::size_t touching() const noexcept;

 private:
  void pick(std::span<const Vec3> position);
  void find_bonds();
  void switch_bonds();
  void begin_bonds();

  BondLaw law_;
  const BondKind& kind_;
  const Particles& particles_;
  double conductivity_;
  double table_skin_;
  NeighbourList list_;
  ContactTable table_;
  std::vector<Vec3> picked_;  // positions when the table was made
  std::vector<Bond> bonds_;   // as the step begins
  BondArrays arrays_;
  mutable Incidence incidence_;
  mutable bool incidence_stands_ = false;
  mutable std::vector<ContactPoint> points_;
  mutable bool points_stand_ = false;
};

}  // namespace superstep::dynamics
