#pragma once
/// How particles of a packing file move, and how warm they are, where the file or one beside it says.

#include <string>
#include <vector>

#include "dynamics/particles.hpp"
#include "packing/packing.hpp"

namespace superstep::dynamics {

/// Empty where nothing is said.
struct Kinematics {
  std::vector<Vec3> velocity;       ///< [n] m/s, in the order of the packing
  std::vector<double> temperature;  ///< [n] K
};

/// From the packing file itself: columns vx vy vz and temperature (also Temp, f_Temp, f_Temp[0]) of the last
/// frame of a LAMMPS or LIGGGHTS dump, the velocities of a MercuryDPM .data file. Other formats have none.
///   unit [m]  length of one unit of the file
[[nodiscard]] Kinematics read_kinematics(const std::string& path, double unit, const Packing& packing);

/// From a CSV with id and any of vx, vy, vz [m/s], temperature [K]: every particle of the packing once.
[[nodiscard]] Kinematics read_state(const std::string& path, const Packing& packing);

/// From a CSV with i, j, overlap, growth: bonds of the packing, sorted by the positions in it.
[[nodiscard]] std::vector<Bond> read_bonds(const std::string& path, const Packing& packing);

}  // namespace superstep::dynamics
