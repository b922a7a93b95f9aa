#pragma once
/// How particles of a packing file move, how warm they are, and which of them are bonded.

#include <optional>
#include <string>
#include <vector>

#include "dynamics/particles.hpp"
#include "packing/packing.hpp"

namespace superstep::dynamics {

/// Empty where nothing is said.
struct Kinematics {
  std::vector<Vec3> velocity;       ///< [n] m/s, in the order of the packing
  std::vector<double> temperature;  ///< [n] K
  std::vector<std::string> unused;  ///< columns that say something else, but for what a press writes itself
};

/// From the columns of the packing at `path`, whatever its format: vx vy vz, velocity:0..2 and the like;
/// temperature, Temp, T, f_Temp, f_Temp[0]. Throws InputError for what is no number, for a velocity with an
/// axis missing, for one in a unit style whose unit of time is not sure, and for two columns of one quantity
/// that differ.
///   unit  m/s per unit of velocity; nothing = that of the file's unit style, else its unit of length per
///         second
[[nodiscard]] Kinematics read_kinematics(const std::string& path, const Packing& packing,
                                         std::optional<double> unit);

/// From a CSV with i, j, overlap, growth: bonds of the packing, sorted by the positions in it.
[[nodiscard]] std::vector<Bond> read_bonds(const std::string& path, const Packing& packing);

}  // namespace superstep::dynamics
