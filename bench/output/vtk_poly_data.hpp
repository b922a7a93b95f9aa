#pragma once
/// VTK files (XML, appended raw binary) that ParaView opens: points and lines with values.
/// Format: "VTK XML file formats", docs.vtk.org; header_type UInt64, byte order of this machine.

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/vec3.hpp"

namespace superstep {

/// Named values, one per point or per cell: numbers or vectors.
struct VtkValues {
  std::string name;
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::uint8_t>, std::vector<Vec3>>
      values;
};

/// A piece of poly data: n points, each a vertex of its own, or joined by lines.
struct VtkPolyData {
  std::span<const Vec3> points;  ///< [n] m
  std::vector<std::pair<std::int64_t, std::int64_t>>
      lines;                          ///< [m] positions; empty = every point is a vertex
  std::vector<VtkValues> point_data;  ///< [n] each
  std::vector<VtkValues> cell_data;   ///< [m] each, only with lines
  double time = 0;                    ///< s
  bool vertices = true;               ///< points without lines are; else nothing is drawn of them
};

/// Content of a .vtp file.
[[nodiscard]] std::string vtp_text(const VtkPolyData& data);

/// Content of a .pvtp file: pieces beside it, all with the arrays of `one` of them.
[[nodiscard]] std::string pvtp_text(const VtkPolyData& one, std::span<const std::string> pieces);

/// Content of a .pvd file: a time series of files beside it.
struct VtkFrame {
  double time = 0;  ///< s
  std::string file;
};
[[nodiscard]] std::string pvd_text(std::span<const VtkFrame> frames);

}  // namespace superstep
