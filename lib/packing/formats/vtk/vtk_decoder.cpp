#include "packing/formats/vtk/vtk_decoder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/text/decoding/compressed.hpp"
#include "core/text/number.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/vtk/base64.hpp"

namespace superstep {

std::string vtk_attribute(const XmlTag& tag, const std::string& name, const std::string& fallback) {
  const auto found = tag.attributes.find(name);
  return found == tag.attributes.end() ? fallback : found->second;
}

std::size_t vtk_count(const std::string& path, const XmlTag& tag, const std::string& name,
                      std::int64_t fallback) {
  const std::string text = vtk_attribute(tag, name);
  const auto value = text.empty() ? std::optional(fallback) : parse_integer(text);
  constexpr std::int64_t most = std::int64_t{1} << 40;
  if (!value || *value < 0 || *value > most)
    throw InputError(fmt::format("{}: {} is {}; it must be a count", path, name, in_quotes(text)));
  return static_cast<std::size_t>(*value);
}

VtkDecoder::VtkDecoder(std::string path, std::string_view content, const XmlTag& tag)
    : path_(std::move(path)), content_(content) {
  big_endian_ = vtk_attribute(tag, "byte_order") == "BigEndian";
  header_size_ = vtk_attribute(tag, "header_type", "UInt32") == "UInt64" ? 8 : 4;
  const std::string compressor = vtk_attribute(tag, "compressor");
  is_compressed_ = !compressor.empty();
  if (is_compressed_ && compressor != "vtkZLibDataCompressor")
    fail(fmt::format("is compressed by {}, which is not read; write it with zlib, or uncompressed",
                     compressor));
  find_appended();
}

void VtkDecoder::fail(const std::string& reason) const {
  throw InputError(fmt::format("{}: {}", path_, reason));
}

void VtkDecoder::cut_off(const std::string& name) const {
  fail(fmt::format(
      "array '{}' is shorter than its header says; the file is cut off or damaged: write it again", name));
}

/// The block of appended data is at the end: what stands in it need not be XML.
void VtkDecoder::find_appended() {
  XmlScanner scanner(content_);
  XmlTag tag;
  while (scanner.next(tag))
    if (tag.name == "AppendedData") {
      const std::size_t mark = content_.find('_', tag.end);
      if (mark == std::string_view::npos) fail("has no '_' before its appended data; write it again");
      appended_ = content_.substr(mark + 1);
      appended_is_base64_ = vtk_attribute(tag, "encoding", "base64") == "base64";
      return;
    }
}

std::vector<double> VtkDecoder::values(const XmlTag& tag, VtkType type, const std::string& name) const {
  const std::string format = vtk_attribute(tag, "format", "ascii");
  const std::size_t end = tag.is_empty ? tag.end : std::min(content_.find('<', tag.end), content_.size());
  const std::string_view inside = content_.substr(tag.end, end - tag.end);
  std::vector<double> out;
  if (format == "ascii") return ascii(inside, name);
  if (format == "binary") {
    append_values(block(inside, true, name), type, big_endian_, out);
  } else if (format == "appended") {
    const std::size_t offset = vtk_count(path_, tag, "offset", 0);
    if (offset >= appended_.size())
      fail(fmt::format("array '{}' begins behind the end of the file; it is cut off", name));
    append_values(block(appended_.substr(offset), appended_is_base64_, name), type, big_endian_, out);
  } else {
    fail(fmt::format("array '{}' has the format {}; it must be ascii, binary or appended", name,
                     in_quotes(format)));
  }
  return out;
}

std::vector<double> VtkDecoder::ascii(std::string_view text, const std::string& name) const {
  constexpr const char* blanks = " \t\r\n";
  std::vector<double> out;
  for (std::size_t at = text.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const auto value = parse_number(word);
    const bool gap = word == "nan" || word == "-nan" || word == "inf" || word == "-inf";
    if (!value && !gap) fail(fmt::format("array '{}' holds {}; it must hold numbers", name, in_quotes(word)));
    out.push_back(value ? *value : std::numeric_limits<double>::quiet_NaN());
    at = text.find_first_not_of(blanks, end);
  }
  return out;
}

/// Bytes from `source`, decoded as far as needed.
std::string VtkDecoder::bytes(std::string_view source, bool base64, std::size_t size,
                              const std::string& name) const {
  std::string out;
  if (size > source.size()) cut_off(name);
  if (base64)
    append_base64(source, size, out);
  else
    out = source.substr(0, size);
  if (out.size() < size) cut_off(name);
  return out;
}

std::size_t VtkDecoder::header_value(std::string_view header, std::size_t k) const {
  std::vector<double> value;
  append_values(header.substr(k * header_size_, header_size_),
                {header_size_, VtkType::Kind::unsigned_integer}, big_endian_, value);
  constexpr double most = 1e15;  // bytes; beyond it a double is no size
  return value[0] > most ? static_cast<std::size_t>(most) : static_cast<std::size_t>(value[0]);
}

/// One array: its length and its bytes, or the lengths of its zlib blocks and the blocks.
std::string VtkDecoder::block(std::string_view source, bool base64, const std::string& name) const {
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
    append_inflated(rest.substr(0, size), unpacked, fmt::format("{}: array '{}'", path_, name), out);
    rest.remove_prefix(size);
  }
  return out;
}

}  // namespace superstep
