#pragma once
/// VTK XML files of points (VTP, VTU): where they are, their data, and lines between them.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "packing/formats/vtk/vtk_array.hpp"

namespace superstep {

struct VtkPoints {
  std::vector<double> points;        ///< [3n]
  std::vector<VtkArray> data;        ///< of points, each with n tuples
  std::vector<std::int64_t> lines;   ///< [2m] the points that each line joins
  std::vector<VtkArray> lines_data;  ///< each with m tuples
};

/// True where a file begins as VTK XML does.
[[nodiscard]] bool is_vtk_xml(std::string_view content);

/// Pieces follow each other; arrays that not all of them have are left out.
///   path        for messages
///   with_lines  cells are read, too: all of them must be lines of two points
/// Throws InputError.
[[nodiscard]] VtkPoints read_vtk_xml(const std::string& path, std::string_view content,
                                     bool with_lines = false);

}  // namespace superstep
