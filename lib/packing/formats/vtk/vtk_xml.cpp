/// VTK XML files of points (VTP, VTU): ASCII, base64 or raw, appended or in place, as they are or in zlib
/// blocks.

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "core/error.hpp"
#include "core/text/compressed.hpp"
#include "core/text/number.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/vtk/base64.hpp"
#include "packing/formats/vtk/vtk_array.hpp"
#include "packing/formats/vtk/xml_scan.hpp"

namespace superstep {
namespace {

bool recognises(const PackingFile& file) {
  constexpr std::size_t looked_at = 1000;
  return file.content.substr(0, looked_at).find("<VTKFile") != std::string_view::npos;
}

class XmlReader {
 public:
  explicit XmlReader(const PackingFile& file) : file_(file), scanner_(file.content) {}

  Packing read() {
    XmlTag tag;
    while (scanner_.next(tag) && tag.name != "AppendedData") {
      if (tag.name == "VTKFile" && !tag.closes) open_file(tag);
      if (tag.name == "Piece" && !tag.closes) open_piece(tag);
      if (tag.name == "Points" || tag.name == "PointData") part_ = tag.closes || tag.is_empty ? "" : tag.name;
      if (tag.name == "DataArray" && !tag.closes) data_array(tag);
    }
    close_piece();
    if (points_.empty()) fail("has no points; at least one is needed");
    return packing_of_points(file_, points_, data_);
  }

 private:
  static std::string attribute(const XmlTag& tag, const std::string& name, const std::string& fallback = {}) {
    const auto found = tag.attributes.find(name);
    return found == tag.attributes.end() ? fallback : found->second;
  }
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(fmt::format("{}: {}", file_.path, reason));
  }
  std::size_t count(const XmlTag& tag, const std::string& name, std::int64_t fallback) const {
    const std::string text = attribute(tag, name);
    const auto value = text.empty() ? std::optional(fallback) : parse_integer(text);
    constexpr std::int64_t most = std::int64_t{1} << 40;
    if (!value || *value < 0 || *value > most)
      fail(fmt::format("{} is {}; it must be a count", name, quoted(text)));
    return static_cast<std::size_t>(*value);
  }

  void open_file(const XmlTag& tag) {
    const std::string type = attribute(tag, "type");
    if (type != "PolyData" && type != "UnstructuredGrid")
      fail(fmt::format(
          "the type is {}; points stand in PolyData or UnstructuredGrid files: write one of these",
          quoted(type)));
    big_endian_ = attribute(tag, "byte_order") == "BigEndian";
    header_size_ = attribute(tag, "header_type", "UInt32") == "UInt64" ? 8 : 4;
    const std::string compressor = attribute(tag, "compressor");
    is_compressed_ = !compressor.empty();
    if (is_compressed_ && compressor != "vtkZLibDataCompressor")
      fail(fmt::format("is compressed by {}, which is not read; write it with zlib, or uncompressed",
                       compressor));
    find_appended();
  }

  /// The block of appended data is at the end: what stands in it need not be XML.
  void find_appended() {
    XmlScanner scanner(file_.content);
    XmlTag tag;
    while (scanner.next(tag))
      if (tag.name == "AppendedData") {
        const std::size_t mark = file_.content.find('_', tag.end);
        if (mark == std::string_view::npos) fail("has no '_' before its appended data; write it again");
        appended_ = file_.content.substr(mark + 1);
        appended_is_base64_ = attribute(tag, "encoding", "base64") == "base64";
        return;
      }
  }

  void open_piece(const XmlTag& tag) {
    close_piece();
    expected_ = count(tag, "NumberOfPoints", 0);
  }

  /// A file may consist of several pieces, each with the same arrays.
  void close_piece() {
    if (piece_points_.size() != 3 * expected_)
      fail(fmt::format("a piece has {} coordinates, and announces {} points; it is damaged: write it again",
                       piece_points_.size(), expected_));
    const std::size_t before = points_.size();
    points_.insert(points_.end(), piece_points_.begin(), piece_points_.end());
    std::erase_if(piece_data_,
                  [&](const VtkArray& one) { return one.value.size() != expected_ * one.components; });
    if (before == 0) {
      data_ = std::move(piece_data_);
    } else if (expected_ > 0) {
      std::erase_if(data_, [&](VtkArray& whole) {
        const auto part = std::find_if(piece_data_.begin(), piece_data_.end(), [&](const VtkArray& one) {
          return one.name == whole.name && one.components == whole.components;
        });
        if (part == piece_data_.end()) return true;
        whole.value.insert(whole.value.end(), part->value.begin(), part->value.end());
        return false;
      });
    }
    piece_points_.clear();
    piece_data_.clear();
    expected_ = 0;
  }

  void data_array(const XmlTag& tag) {
    const bool wanted = part_ == "Points" || part_ == "PointData";
    const std::string format = attribute(tag, "format", "ascii");
    const std::size_t end =
        tag.is_empty ? tag.end : std::min(file_.content.find('<', tag.end), file_.content.size());
    const std::string_view inside = file_.content.substr(tag.end, end - tag.end);
    if (!wanted) return;
    const std::string name = attribute(tag, "Name", part_);
    constexpr std::size_t most = 1000;  // components; more is a slip
    const std::size_t components = count(tag, "NumberOfComponents", part_ == "Points" ? 3 : 1);
    if (components == 0 || components > most) return;
    const std::string type_name = attribute(tag, "type");
    const auto type = vtk_type(type_name);
    if (!type) return;  // strings
    std::vector<double> values;
    if (format == "ascii")
      read_ascii(inside, name, values);
    else if (format == "binary")
      append_values(block(inside, true, name), *type, big_endian_, values);
    else if (format == "appended")
      append_values(appended_block(tag, name), *type, big_endian_, values);
    else
      fail(fmt::format("array '{}' has the format {}; it must be ascii, binary or appended", name,
                       quoted(format)));
    if (part_ == "Points")
      piece_points_ = std::move(values);
    else
      piece_data_.push_back({name, components, std::move(values)});
  }

  void read_ascii(std::string_view text, const std::string& name, std::vector<double>& out) const {
    constexpr const char* blanks = " \t\r\n";
    for (std::size_t at = text.find_first_not_of(blanks); at != std::string_view::npos;) {
      const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
      const std::string_view word = text.substr(at, end - at);
      const auto value = parse_number(word);
      const bool gap = word == "nan" || word == "-nan" || word == "inf" || word == "-inf";
      if (!value && !gap) fail(fmt::format("array '{}' holds {}; it must hold numbers", name, quoted(word)));
      out.push_back(value ? *value : std::numeric_limits<double>::quiet_NaN());
      at = text.find_first_not_of(blanks, end);
    }
  }

  std::string appended_block(const XmlTag& tag, const std::string& name) {
    const std::size_t offset = count(tag, "offset", 0);
    if (offset >= appended_.size())
      fail(fmt::format("array '{}' begins behind the end of the file; it is cut off", name));
    return block(appended_.substr(offset), appended_is_base64_, name);
  }

  /// Bytes from `source`, decoded as far as needed.
  std::string bytes(std::string_view source, bool base64, std::size_t size, const std::string& name) const {
    std::string out;
    if (size > source.size()) cut_off(name);
    if (base64)
      append_base64(source, size, out);
    else
      out = source.substr(0, size);
    if (out.size() < size) cut_off(name);
    return out;
  }
  [[noreturn]] void cut_off(const std::string& name) const {
    fail(fmt::format(
        "array '{}' is shorter than its header says; the file is cut off or damaged: write it again", name));
  }
  std::size_t header_value(std::string_view header, std::size_t k) const {
    std::vector<double> value;
    append_values(header.substr(k * header_size_, header_size_),
                  {header_size_, VtkType::Kind::unsigned_integer}, big_endian_, value);
    constexpr double most = 1e15;  // bytes; beyond it a double is no size
    return value[0] > most ? static_cast<std::size_t>(most) : static_cast<std::size_t>(value[0]);
  }

  /// One array: its length and its bytes, or the lengths of its zlib blocks and the blocks.
  std::string block(std::string_view source, bool base64, const std::string& name) {
    if (base64) source = source.substr(std::min(source.find_first_not_of(" \t\r\n"), source.size()));
    const std::string first = bytes(source, base64, header_size_, name);
    const std::size_t leading = header_value(first, 0);
    if (!is_compressed_) {
      const std::string all = bytes(source, base64, header_size_ + std::min(leading, source.size()), name);
      if (leading > source.size()) cut_off(name);
      return all.substr(header_size_);
    }
    if (leading == 0) return {};
    if (leading > source.size()) cut_off(name);
    const std::size_t header_bytes = (3 + leading) * header_size_;
    const std::string header = bytes(source, base64, header_bytes, name);
    const std::size_t full = header_value(header, 1), last = header_value(header, 2);
    std::size_t packed = 0;
    for (std::size_t k = 0; k < leading; ++k) packed += std::min(header_value(header, 3 + k), source.size());
    const std::string all = bytes(source, base64, header_bytes + std::min(packed, source.size()), name);
    if (packed > source.size()) cut_off(name);
    std::string out;
    std::string_view rest = std::string_view(all).substr(header_bytes);
    for (std::size_t k = 0; k < leading; ++k) {
      const std::size_t size = header_value(header, 3 + k);
      constexpr std::size_t deflate_most = 1100;  // a byte of zlib stands for no more
      const std::size_t unpacked = k + 1 == leading && last > 0 ? last : full;
      if (unpacked / deflate_most > size) cut_off(name);
      append_inflated(rest.substr(0, size), unpacked, fmt::format("{}: array '{}'", file_.path, name), out);
      rest.remove_prefix(size);
    }
    return out;
  }

  const PackingFile& file_;
  XmlScanner scanner_;
  std::string part_;  ///< "Points", "PointData", or neither
  std::string_view appended_;
  bool big_endian_ = false, is_compressed_ = false, appended_is_base64_ = false;
  std::size_t header_size_ = 4, expected_ = 0;
  std::vector<double> points_, piece_points_;
  std::vector<VtkArray> data_, piece_data_;
};

Packing read(const PackingFile& file) {
  return XmlReader(file).read();
}

}  // namespace

PackingFormat vtk_xml_format() {
  return {"VTK XML (VTP, VTU)", recognises, read};
}

}  // namespace superstep
