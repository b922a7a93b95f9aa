#pragma once
/// What the columns of a table of particles hold, by their names.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text/delimited.hpp"

namespace superstep {

struct SphereColumns {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  enum class Positions { plain, unwrapped, scaled, scaled_unwrapped };
  using Axes = std::array<std::size_t, 3>;

  std::size_t id = none, radius = none, diameter = none, material = none;
  Axes position = {none, none, none};  ///< of x, y and z; none for the z of a plane
  Axes second_position = {none, none,
                          none};  ///< the same under other names, which must agree; none = there is none
  Positions positions = Positions::plain;
  bool material_is_number = false;      ///< a type or the like: one value for all is no material
  std::optional<double> unit;           ///< m; that the columns of positions say of themselves
  double radius_unit = 1;               ///< in units of positions
  double diameter_unit = 1;             ///< the same
  double second_unit = 1;               ///< the same, of second_position
  std::vector<std::size_t> attributes;  ///< every other column that has a name
  /// A column and another one of the very same name, which must have the same values.
  std::vector<std::pair<std::size_t, std::size_t>> repeated;
  std::vector<std::size_t> row_numbers;  ///< columns without a name, as spreadsheets put before the first

  [[nodiscard]] bool is_scaled() const noexcept {
    return positions == Positions::scaled || positions == Positions::scaled_unwrapped;
  }
  [[nodiscard]] bool is_unwrapped() const noexcept {
    return positions == Positions::unwrapped || positions == Positions::scaled_unwrapped;
  }
};

/// What a format makes of names.
struct ColumnRules {
  bool lammps =
      false;          ///< positions may be scaled (xs) or unwrapped (xu); c_, d_, f_, i_, v_ begin attributes
  bool flat = false;  ///< two dimensions: there is no z
  std::optional<std::size_t> positions_at =
      {};  ///< where the format itself has x y z: no others can be meant
};

/// Finds the columns: upper and lower case, blanks and underscores do not matter, and the usual names are
/// known (r, d, Points:0, pos_x, "radius [mm]", ...). Where several would do, the more usual name wins and
/// the others are attributes; a position is taken from names of one kind.
///   place, header   "file:line" and what the names stand in, for messages
/// Throws InputError for a missing column, with the nearest name, and for names of which only upper and lower
/// case, blanks or units differ. The very same name again is `repeated`.
[[nodiscard]] SphereColumns find_sphere_columns(std::span<const std::string> names, const ColumnRules& rules,
                                                const std::string& place, const std::string& header);

/// Headers of particles in comments: they name a size, whatever they call the rest.
[[nodiscard]] const HeaderRule& sphere_header_rule();

/// True when the names hold a position in three dimensions.
[[nodiscard]] bool names_a_position(std::span<const std::string> names);

/// Optional columns that a name looks like a misspelling of ("matrial"); empty for none.
[[nodiscard]] std::string likely_misspelling(const std::string& name);

}  // namespace superstep
