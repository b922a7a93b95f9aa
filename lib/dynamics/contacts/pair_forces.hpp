#pragma once
/// Forces between particles, pair by pair in vector registers.

#include <functional>
#include <span>
#include <vector>

#include "dynamics/contacts/contact_table.hpp"
#include "dynamics/laws/contact_law.hpp"

namespace superstep::dynamics {

/// Room for what all pairs do.
struct PairForces {
  std::vector<double> x, y, z;  ///< on i [N]
  // Of the last call that asked for the whole.
  std::vector<double> elastic;     ///< power that contact and bond take up [W]
  std::vector<double> dissipated;  ///< in damping and friction [W]
  std::vector<double> slope;       ///< of the repulsion with the overlap [N/m]
  std::vector<double> resistance;  ///< bound of the slope of damping and friction with the speed [kg/s]
};

enum class PairDetail : char {
  forces,
  whole,  ///< with powers and slopes, which a step needs where it begins
};

/// Adds the forces of all pairs to those of their particles: repulsion, damping and friction of the contact,
/// and what the table says of bonds. A pair's force is applied with opposite signs, so that it cannot change
/// the total momentum. Each particle adds its pairs in the order of the table, whoever does it: the same bits
/// for any number of threads.
///   incidence  of the table; asked for when threads take part
void add_pair_forces(const ContactLaw& law, const ContactTable& table, std::span<const Vec3> velocity,
                     std::span<const double> temperature, PairDetail detail, PairForces& room,
                     std::span<Vec3> force, const std::function<const Incidence&()>& incidence);

}  // namespace superstep::dynamics
