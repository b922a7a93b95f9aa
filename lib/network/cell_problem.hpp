#pragma once
/// Effective conductivity of a periodic packing: a mean gradient is imposed, and what varies around it
/// repeats.

#include <array>
#include <span>

#include "contact/contact.hpp"

namespace superstep {

/// tensor[a][b]: mean flux along -a for a mean gradient of 1 along b.
using ConductivityTensor = std::array<std::array<double, 3>, 3>;

/// Solves sum_j K_ij (G . d_ij + theta_j - theta_i) = 0 for the part theta that repeats, with d_ij the branch
/// vectors across the cell's sides, and averages K (G . d + theta_j - theta_i) d over the cell's volume; by a
/// direct solver. Entries of axes along which no contacts lead through the cell are 0; those along open edges
/// of the cell have no meaning.
///   contacts     with their images, those of spheres with their own images included
///   conductance  [contacts] W/K or S, >= 0
/// Returns W/(m K) or S/m. Throws NumericalError.
[[nodiscard]] ConductivityTensor periodic_conductivity(const Packing& packing, const Contacts& contacts,
                                                       std::span<const double> conductance);

}  // namespace superstep
