#pragma once
/// Forces between particles, pair by pair in vector registers.

#include <functional>
#include <span>
#include <vector>

#include "dynamics/contacts/contact_table.hpp"
#include "dynamics/laws/contact_law.hpp"

namespace superstep::dynamics {

/// Room for the forces of all pairs [N].
struct PairForces {
  std::vector<double> x, y, z;
};

/// Adds the forces of all pairs to those of their particles: repulsion, damping and friction of the contact,
/// and what the table says of bonds. A pair's force is applied with opposite signs, so that it cannot change
/// the total momentum. Each particle adds its pairs in the order of the table, whoever does it: the same bits
/// for any number of threads.
///   incidence  of the table; asked for when threads take part
void add_pair_forces(const ContactLaw& law, const ContactTable& table, std::span<const Vec3> velocity,
                     std::span<const double> temperature, PairForces& room, std::span<Vec3> force,
                     const std::function<const Incidence&()>& incidence);

}  // namespace superstep::dynamics
