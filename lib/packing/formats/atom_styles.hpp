#pragma once
/// Orders of the columns in the section Atoms of a LAMMPS data file.

#include <string>
#include <vector>

namespace superstep {

struct AtomLayout {
  std::string style;                 ///< "sphere", "hybrid sphere bond", ...
  std::vector<std::string> columns;  ///< without the three image flags that may follow
};

/// The order of a style in full, as in "sphere" or "hybrid sphere bond". Throws InputError (beginning with
/// `where`) for one that does not know diameters, or that is not known here.
[[nodiscard]] AtomLayout atom_layout(const std::string& style, const std::string& where);

/// Every order with so many columns in which positions and diameters stand at places of their own. With
/// `hybrid_only`, those of hybrid styles.
[[nodiscard]] std::vector<AtomLayout> atom_layouts(std::size_t columns, bool hybrid_only);

}  // namespace superstep
