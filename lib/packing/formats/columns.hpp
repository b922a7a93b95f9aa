#pragma once
/// What the columns of a table of particles hold, by their names.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace superstep {

struct SphereColumns {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  enum class Positions { plain, unwrapped, scaled, scaled_unwrapped };

  std::size_t id = none, x = none, y = none, z = none, radius = none, diameter = none, material = none;
  Positions positions = Positions::plain;
  bool material_is_number = false;       ///< a type or the like: one value for all is no material
  std::optional<double> unit;            ///< m; that the columns of positions say of themselves
  double size_factor = 1;                ///< unit of radius or diameter in units of positions
  std::vector<std::size_t> attributes;   ///< every other column that has a name
  std::vector<std::size_t> row_numbers;  ///< columns without a name, as spreadsheets put before the first

  [[nodiscard]] bool is_scaled() const noexcept {
    return positions == Positions::scaled || positions == Positions::scaled_unwrapped;
  }
  [[nodiscard]] bool is_unwrapped() const noexcept {
    return positions == Positions::unwrapped || positions == Positions::scaled_unwrapped;
  }
};

/// Finds the columns: upper and lower case, blanks and underscores do not matter, and the usual names are
/// known (r, d, Points:0, pos_x, "radius [mm]", ...). Where several would do, the more usual name wins and
/// the others are attributes.
///   lammps  positions may be scaled (xs) or unwrapped (xu)
///   flat    two dimensions: there is no z
///   place, header   "file:line" and what the names stand in, for messages
/// Throws InputError for a missing column, with the nearest name, and for one that stands twice.
[[nodiscard]] SphereColumns find_sphere_columns(std::span<const std::string> names, bool lammps, bool flat,
                                                const std::string& place, const std::string& header);

/// True when the names hold a position in three dimensions.
[[nodiscard]] bool names_a_position(std::span<const std::string> names);

/// Optional columns that a name looks like a misspelling of ("matrial"); empty for none.
[[nodiscard]] std::string likely_misspelling(const std::string& name);

}  // namespace superstep
