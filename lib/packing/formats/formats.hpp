#pragma once
/// One reader per file format; `read_packing` chooses. Each throws InputError that names file, line, value
/// and rule.

#include <string>
#include <string_view>

#include "packing/packing.hpp"

namespace superstep {

/// What a reader is given: the path for messages, the whole text, the length of one unit [m].
struct PackingFile {
  std::string path;
  std::string_view text;
  double unit = 1;
};

/// Header `x,y,z,radius` with optional `id` and `material`, in any order. Opens the path itself.
[[nodiscard]] Packing read_csv(const std::string& path, double unit);
/// LAMMPS/LIGGGHTS dump: the last frame, columns in any order.
[[nodiscard]] Packing read_lammps_dump(const PackingFile& file);
/// LAMMPS/LIGGGHTS data: section Atoms of atom style sphere or granular.
[[nodiscard]] Packing read_lammps_data(const PackingFile& file);
/// Yade text with `#format x_y_z_r` or `#format x_y_z_r_matId`.
[[nodiscard]] Packing read_yade(const PackingFile& file);
/// MercuryDPM .data in three dimensions: the last frame.
[[nodiscard]] Packing read_mercury(const PackingFile& file);

}  // namespace superstep
