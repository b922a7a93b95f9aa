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

/// True for a file that `read_packing` takes.
[[nodiscard]] bool reads_as_packing(const std::string& path);

/// Metres per unit for "m", "mm", "um", "nm", "cm". Throws InputError (beginning with `where`) for any other
/// name.
[[nodiscard]] double length_unit(const std::string& name, const std::string& where);

/// Name of the unit of length that a packing file states in its comments, as in `# length_unit = "um"`; empty
/// when it states none. Throws InputError for a unit that does not exist; whether the
/// file can be read is for whoever reads the rest.
[[nodiscard]] std::string stated_length_unit(const std::string& path);

/// CSV text `id,x,y,z,radius[,material]` in metres, which its first line states, with enough digits to read
/// back the same contacts.
[[nodiscard]] std::string packing_csv(const Packing& packing);

}  // namespace superstep
