#include "bench/output/vtk_poly_data.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <stdexcept>

#include "results/text/html_text.hpp"

namespace superstep {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double), "points and vectors are written as they lie in memory");

constexpr const char* byte_order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

template <class Value>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<Value, std::int64_t>) return "Int64";
  if constexpr (std::is_same_v<Value, std::uint8_t>) return "UInt8";
  return "Float64";
}

/// The XML part and the binary part of a file, which grow together.
class Appended {
 public:
  template <class Value>
  std::string array(const std::string& name, int components, std::span<const Value> values) {
    const std::size_t offset = bytes_.size();
    const std::uint64_t size = values.size_bytes();
    append(&size, sizeof size);
    append(values.data(), values.size_bytes());
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
        type_name<Value>(), html_text(name), components, offset);
  }
  std::string arrays(const char* element, const std::vector<VtkValues>& list, std::size_t expected) {
    std::string out = fmt::format("<{}>\n", element);
    for (const auto& one : list)
      out += std::visit(
          [&](const auto& values) {
            if (values.size() != expected)
              throw std::logic_error("a VTK array has the wrong length: " + one.name);
            return whole(one.name, values);
          },
          one.values);
    return out + fmt::format("</{}>\n", element);
  }
  template <class Value>
  std::string whole(const std::string& name, const std::vector<Value>& values) {
    if constexpr (std::is_same_v<Value, Vec3>)
      return vectors(name, values);
    else
      return array(name, 1, std::span<const Value>(values));
  }
  std::string vectors(const std::string& name, std::span<const Vec3> values) {
    const double* first = values.empty() ? nullptr : &values.front().x;
    return array(name, 3, std::span<const double>(first, 3 * values.size()));
  }
  [[nodiscard]] const std::string& bytes() const noexcept { return bytes_; }

 private:
  void append(const void* data, std::size_t size) {
    if (size > 0) bytes_.append(static_cast<const char*>(data), size);
  }
  std::string bytes_;
};

std::string cells(Appended& appended, const char* element, const std::vector<std::int64_t>& connectivity,
                  std::int64_t corners) {
  std::vector<std::int64_t> offsets;
  const auto last = static_cast<std::int64_t>(connectivity.size());
  for (std::int64_t end = corners; end <= last; end += corners) offsets.push_back(end);
  std::string out = fmt::format("<{}>\n", element);
  out += appended.array("connectivity", 1, std::span<const std::int64_t>(connectivity));
  out += appended.array("offsets", 1, std::span<const std::int64_t>(offsets));
  return out + fmt::format("</{}>\n", element);
}

std::string topology(Appended& appended, const VtkPolyData& data) {
  std::vector<std::int64_t> connectivity;
  if (data.lines.empty() && data.vertices) {
    for (std::size_t i = 0; i < data.points.size(); ++i) connectivity.push_back(static_cast<std::int64_t>(i));
    return cells(appended, "Verts", connectivity, 1);
  }
  for (const auto& [i, j] : data.lines) connectivity.insert(connectivity.end(), {i, j});
  return cells(appended, "Lines", connectivity, 2);
}

/// What is said of arrays whose values are in other files.
std::string named_arrays(const char* element, const std::vector<VtkValues>& list) {
  std::string out = fmt::format("<{}>\n", element);
  for (const auto& one : list)
    std::visit(
        [&]<class Value>(const std::vector<Value>&) {
          out += fmt::format("<PDataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"/>\n",
                             type_name<Value>(), html_text(one.name), std::is_same_v<Value, Vec3> ? 3 : 1);
        },
        one.values);
  return out + fmt::format("</{}>\n", element);
}

}  // namespace

std::string vtp_text(const VtkPolyData& data) {
  Appended appended;
  std::string out = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{}\" "
      "header_type=\"UInt64\">\n"
      "<PolyData>\n<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}"
      "</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
      byte_order, data.time, data.points.size(), data.lines.empty() && data.vertices ? data.points.size() : 0,
      data.lines.size());
  out += appended.arrays("PointData", data.point_data, data.points.size());
  out += appended.arrays("CellData", data.cell_data, data.lines.size());
  out += "<Points>\n" + appended.vectors("Points", data.points) + "</Points>\n";
  out += topology(appended, data);
  out += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  return out + appended.bytes() + "\n</AppendedData>\n</VTKFile>\n";
}

std::string pvtp_text(const VtkPolyData& one, std::span<const std::string> pieces) {
  std::string out = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PPolyData\" version=\"1.0\" byte_order=\"{}\" "
      "header_type=\"UInt64\">\n<PPolyData GhostLevel=\"0\">\n",
      byte_order);
  out += named_arrays("PPointData", one.point_data) + named_arrays("PCellData", one.cell_data);
  out += "<PPoints>\n<PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n</PPoints>\n";
  for (const auto& piece : pieces) out += fmt::format("<Piece Source=\"{}\"/>\n", html_text(piece));
  return out + "</PPolyData>\n</VTKFile>\n";
}

std::string pvd_text(std::span<const VtkFrame> frames) {
  std::string out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (const auto& frame : frames)
    out +=
        fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", frame.time, html_text(frame.file));
  return out + "</Collection>\n</VTKFile>\n";
}

}  // namespace superstep
