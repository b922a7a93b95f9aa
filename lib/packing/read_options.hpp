#pragma once
/// What a user may have to say about a packing file because the file does not, or says it wrongly.

#include <optional>
#include <string>
#include <vector>

#include "packing/cell.hpp"

namespace superstep {

struct PackingOptions {
  std::optional<double> length_unit;  ///< m, of the file's lengths; nothing = as the file says, else 1
  std::string place;                  ///< where all this is said, to begin an error message with
  std::string periodic = "auto";      ///< "auto" = as the file says, "none", or axes as in "xy"
  bool has_walls = false;             ///< why nothing is periodic: walls take the place of the box
  std::string units = "auto";   ///< unit style of the code that wrote the file; "auto" = as the file says
  std::string format = "auto";  ///< name of a format that cannot be told by its content
  std::string atom_style;       ///< LAMMPS data: style of the section Atoms; empty = as the file says
  std::vector<std::string>
      columns;              ///< names of the columns, for files that do not name them; empty = as they do
  std::optional<Cell> box;  ///< in lengths of the file; where it states none
  bool in_layers = false;   ///< particles in the order of parts/layers.hpp, not in that of the file
};

}  // namespace superstep
