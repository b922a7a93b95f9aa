#include "packing/formats/vtk/vtk_xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/vtk/vtk_decoder.hpp"
#include "packing/formats/vtk/xml_scan.hpp"

namespace superstep {
namespace {

class XmlReader {
 public:
  XmlReader(const std::string& path, std::string_view content, bool with_lines)
      : path_(path), content_(content), with_lines_(with_lines), scanner_(content) {}

  VtkPoints read() {
    XmlTag tag;
    while (scanner_.next(tag) && tag.name != "AppendedData") {
      if (tag.name == "VTKFile" && !tag.closes) open_file(tag);
      if (tag.name == "Piece" && !tag.closes) open_piece(tag);
      if (wanted(tag.name)) part_ = tag.closes || tag.is_empty ? "" : tag.name;
      if (tag.name == "DataArray" && !tag.closes) data_array(tag);
    }
    close_piece();
    if (whole_.points.empty()) fail("has no points; at least one is needed");
    return std::move(whole_);
  }

 private:
  [[nodiscard]] bool wanted(const std::string& part) const {
    return part == "Points" || part == "PointData" ||
           (with_lines_ && (part == "Lines" || part == "Cells" || part == "CellData"));
  }
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(fmt::format("{}: {}", path_, reason));
  }

  void open_file(const XmlTag& tag) {
    const std::string type = vtk_attribute(tag, "type");
    if (type != "PolyData" && type != "UnstructuredGrid")
      fail(fmt::format(
          "the type is {}; points stand in PolyData or UnstructuredGrid files: write one of these",
          in_quotes(type)));
    decoder_.emplace(path_, content_, tag);
  }

  void open_piece(const XmlTag& tag) {
    close_piece();
    points_expected_ = vtk_count(path_, tag, "NumberOfPoints", 0);
    if (!with_lines_) return;
    for (const char* other : {"NumberOfVerts", "NumberOfStrips", "NumberOfPolys"})
      if (vtk_count(path_, tag, other, 0) > 0)
        fail(fmt::format("{} is not 0; the cells of a network must be lines", other));
    lines_expected_ = vtk_count(path_, tag, "NumberOfLines", 0) + vtk_count(path_, tag, "NumberOfCells", 0);
  }

  /// A file may consist of several pieces, each with the same arrays.
  void close_piece() {
    if (piece_.points.size() != 3 * points_expected_)
      fail(fmt::format("a piece has {} coordinates, and announces {} points; it is damaged: write it again",
                       piece_.points.size(), points_expected_));
    take_lines();
    const bool first_points = whole_.points.empty(), first_lines = whole_.lines.empty();
    whole_.points.insert(whole_.points.end(), piece_.points.begin(), piece_.points.end());
    whole_.lines.insert(whole_.lines.end(), piece_.lines.begin(), piece_.lines.end());
    append(piece_.data, points_expected_, first_points, whole_.data);
    append(piece_.lines_data, lines_expected_, first_lines, whole_.lines_data);
    piece_ = {};
    connectivity_.clear(), offsets_.clear(), types_.clear();
    points_expected_ = lines_expected_ = 0;
  }

  static void append(std::vector<VtkArray>& piece, std::size_t tuples, bool first,
                     std::vector<VtkArray>& whole) {
    std::erase_if(piece, [&](const VtkArray& one) { return one.value.size() != tuples * one.components; });
    if (first) {
      whole = std::move(piece);
    } else if (tuples > 0) {
      std::erase_if(whole, [&](VtkArray& array) {
        const auto part = std::find_if(piece.begin(), piece.end(), [&](const VtkArray& one) {
          return one.name == array.name && one.components == array.components;
        });
        if (part == piece.end()) return true;
        array.value.insert(array.value.end(), part->value.begin(), part->value.end());
        return false;
      });
    }
  }

  /// Each line has two points; those of a piece are counted within it.
  void take_lines() {
    if (offsets_.size() != lines_expected_ || connectivity_.size() != 2 * lines_expected_)
      fail(fmt::format("a piece announces {} lines, and joins {} points by {}; each line must join two",
                       lines_expected_, connectivity_.size(), offsets_.size()));
    constexpr double a_line = 3;  // VTK_LINE
    for (const double type : types_)
      if (type != a_line)
        fail(fmt::format("a cell has the type {}; the cells of a network must be lines (3)", type));
    const auto before = static_cast<std::int64_t>(whole_.points.size() / 3);
    for (std::size_t k = 0; k < offsets_.size(); ++k)
      if (offsets_[k] != 2.0 * static_cast<double>(k + 1))
        fail(fmt::format("line {} does not join two points; each line of a network must", k));
    for (const double point : connectivity_) {
      if (!(point >= 0 && point < static_cast<double>(points_expected_)) || point != std::floor(point))
        fail(fmt::format("a line joins point {}; it must be one of the {} of its piece, counted from 0",
                         point, points_expected_));
      piece_.lines.push_back(before + static_cast<std::int64_t>(point));
    }
  }

  void data_array(const XmlTag& tag) {
    if (part_.empty() || !decoder_) return;
    const std::string name = vtk_attribute(tag, "Name", part_);
    constexpr std::size_t most = 1000;  // components; more is a slip
    const std::size_t components = vtk_count(path_, tag, "NumberOfComponents", part_ == "Points" ? 3 : 1);
    if (components == 0 || components > most) return;
    const auto type = vtk_type(vtk_attribute(tag, "type"));
    if (!type) return;  // strings
    std::vector<double> values = decoder_->values(tag, *type, name);
    if (part_ == "Points")
      piece_.points = std::move(values);
    else if (part_ == "PointData")
      piece_.data.push_back({name, components, std::move(values)});
    else if (part_ == "CellData")
      piece_.lines_data.push_back({name, components, std::move(values)});
    else if (name == "connectivity")
      connectivity_ = std::move(values);
    else if (name == "offsets")
      offsets_ = std::move(values);
    else if (name == "types")
      types_ = std::move(values);
  }

  const std::string& path_;
  std::string_view content_;
  bool with_lines_;
  XmlScanner scanner_;
  std::optional<VtkDecoder> decoder_;
  std::string part_;  ///< whose arrays come; empty = none that is wanted
  std::size_t points_expected_ = 0, lines_expected_ = 0;
  std::vector<double> connectivity_, offsets_, types_;
  VtkPoints whole_, piece_;
};

}  // namespace

bool is_vtk_xml(std::string_view content) {
  constexpr std::size_t looked_at = 1000;
  return content.substr(0, looked_at).find("<VTKFile") != std::string_view::npos;
}

VtkPoints read_vtk_xml(const std::string& path, std::string_view content, bool with_lines) {
  return XmlReader(path, content, with_lines).read();
}

}  // namespace superstep
