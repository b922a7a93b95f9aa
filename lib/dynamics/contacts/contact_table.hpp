#pragma once
/// Pairs that are near each other and their geometry at one instant, structure of arrays.

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec3.hpp"

namespace superstep::dynamics {

/// One entry a pair, sorted by (i, j). What does not change while the list stands comes first.
struct ContactTable {
  std::vector<std::int32_t> i, j;
  std::vector<double> radius_sum;         ///< r_i + r_j [m]
  std::vector<double> square;             ///< r_i^2 [m2]
  std::vector<double> square_difference;  ///< r_j^2 - r_i^2 [m2]
  std::vector<double> reduced_mass;       ///< kg
  std::vector<double> hardness;           ///< harmonic mean of the two: one after the other
  std::vector<double> conductivity;       ///< of heat, mean of the two [W/(m K)]
  // Of the instant. Pairs that do not touch have area 0.
  std::vector<double> nx, ny, nz;  ///< unit vector from i to j
  std::vector<double> strain;      ///< E, < 0 in contact
  std::vector<double> area;        ///< A_c of the contact [m2]
  std::vector<double> flow;        ///< area over distance, through contact or neck [m]
  // What bonds do: 1, 0, 0 where there is none.
  std::vector<double> keep;     ///< part of the contact's force that is left
  std::vector<double> pull;     ///< N
  std::vector<double> damping;  ///< kg/s

  [[nodiscard]] std::size_t size() const noexcept { return i.size(); }
  void resize(std::size_t pairs);
};

/// Pairs of each particle, in ascending order: its sums can be taken alone, in the order of the pairs.
struct Incidence {
  std::vector<std::size_t> begin;   ///< [n + 1]
  std::vector<std::int32_t> entry;  ///< 2 k where the particle is i of pair k, 2 k + 1 where it is j

  void build(const ContactTable& table, std::size_t particles);
};

/// Normals, strains, areas and flows of the pairs [first, last) at these positions.
void place_pairs(ContactTable& table, std::span<const Vec3> position, std::size_t first, std::size_t last);

}  // namespace superstep::dynamics
