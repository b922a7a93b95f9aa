#pragma once
/// Packing files that users have, told apart by their content.

#include <string>

#include "packing/packing.hpp"

namespace superstep {

/// Reads CSV, LAMMPS/LIGGGHTS dump or data, Yade text or MercuryDPM .data (the last frame of a file with
/// several).
///   unit [m]  length of one unit of the file, > 0
/// Checks: numbers finite, radii > 0, ids unique, no coincident centres, at least one particle.
/// Throws InputError that names file, line, value and rule.
[[nodiscard]] Packing read_packing(const std::string& path, double unit = 1.0);

/// Metres per unit for "m", "mm", "um", "nm", "cm". Throws InputError (beginning with `where`) for any other
/// name.
[[nodiscard]] double length_unit(const std::string& name, const std::string& where);

/// CSV text `id,x,y,z,radius[,material]` in metres with enough digits to read back the same contacts.
[[nodiscard]] std::string packing_csv(const Packing& packing);

}  // namespace superstep
