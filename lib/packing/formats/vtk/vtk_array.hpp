#pragma once
/// Arrays of VTK files as doubles, whatever type they have, and a packing made of them.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "packing/formats/formats.hpp"

namespace superstep {

/// n tuples of a few components.
struct VtkArray {
  std::string name;
  std::size_t components = 1;
  std::vector<double> value;  ///< [n * components]
};

/// A type of numbers.
struct VtkType {
  std::size_t size = 0;  ///< bytes
  enum class Kind { signed_integer, unsigned_integer, floating } kind = Kind::floating;
};

/// Types by the names of XML files ("Float32", "Int64") and of legacy ones ("float", "vtktypeint64",
/// "unsigned_char").
[[nodiscard]] std::optional<VtkType> vtk_type(std::string_view name);

/// Appends all values that the bytes hold.
void append_values(std::string_view bytes, VtkType type, bool big_endian, std::vector<double>& out);

/// Points with their data as a packing: a scalar that is called radius or diameter (in any of the usual ways)
/// makes them spheres. Arrays that do not have a tuple for each point must have been left out. Throws
/// InputError.
[[nodiscard]] Packing packing_of_points(const PackingFile& file, const std::vector<double>& points,
                                        const std::vector<VtkArray>& data);

}  // namespace superstep
