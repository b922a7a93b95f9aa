#pragma once
/// What people call the columns of particles, and the units that stand behind these names.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace superstep {

/// A name with everything taken off that people write differently, and the unit that stood behind it.
struct PlainName {
  std::string name;  ///< lower case, without blanks and ASCII signs; letters beyond ASCII stay
  std::optional<double> unit;
  std::string unknown_unit;  ///< what stands in brackets and is no unit of length; `name` includes it
};

/// "Radius [mm]", "x (um)", "x_mm": the part before the unit, and the unit.
[[nodiscard]] PlainName plain_name(std::string_view written);
/// The name alone, also where its unit is unknown.
[[nodiscard]] std::string name_without_unit(std::string_view written);

/// Names of x, y and z that belong together, as plain names: a position is never put together from several.
using CoordinateNames = std::array<std::string, 3>;

/// All of them, the more usual ones first: x y z, points0 points1 points2, ...
[[nodiscard]] const std::vector<CoordinateNames>& coordinate_names();

[[nodiscard]] const std::vector<std::string>& id_names();
[[nodiscard]] const std::vector<std::string>& radius_names();
[[nodiscard]] const std::vector<std::string>& diameter_names();
[[nodiscard]] const std::vector<std::string>& material_names();

/// A column that holds the time of each row, or the number of its step.
[[nodiscard]] bool names_a_time(std::string_view written);

/// "x", "y", "z", "radius", "diameter", "id" or "material"; empty for what is an attribute.
[[nodiscard]] std::string usual_meaning(std::string_view written);

}  // namespace superstep
