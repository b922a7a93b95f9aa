/// Rows of four doubles, little-endian: x y z and diameter (`.xyzd`, as packing generators write it) or
/// radius
/// (`.xyzr`).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "core/error.hpp"
#include "core/text/decoding/encoding.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/sphere_rows.hpp"

namespace superstep {
namespace {

constexpr std::size_t row_size = 4 * sizeof(double);

/// Text holds none of these, however it is encoded; a few random doubles do.
bool holds_control_characters(std::string_view bytes) {
  constexpr std::size_t looked_at = 4096;
  const std::string text = to_utf8(std::string(bytes.substr(0, looked_at)));
  return std::any_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
  });
}

/// "xyzd" or "xyzr", as declared or, for a file that is no text, by its name; else empty.
std::string kind_of(const std::string& path, std::string_view bytes, const PackingOptions& options) {
  for (const char* kind : {"xyzd", "xyzr"}) {
    if (options.format == kind) return kind;
    if (options.format == "auto" && path.ends_with(std::string(".") + kind) &&
        holds_control_characters(bytes))
      return kind;
  }
  return {};
}

bool recognises(const PackingFile& file) {
  return !kind_of(file.path, file.content, file.options).empty();
}

double little_endian(std::string_view bytes) noexcept {
  std::uint64_t bits = 0;
  for (std::size_t k = sizeof bits; k-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[k]);
  return std::bit_cast<double>(bits);
}

Packing read(const PackingFile& file) {
  if (file.content.size() % row_size != 0)
    throw InputError(
        fmt::format("{}: has {} bytes, which is no number of rows of four doubles (32 bytes); it is cut off, "
                    "or another format",
                    file.path, file.content.size()));
  const std::string kind = kind_of(file.path, file.content, file.options);
  SphereRows rows(file, {.names = {"x", "y", "z", kind == "xyzd" ? "diameter" : "radius"},
                         .place = file.path,
                         .header = "the format",
                         .row = "row"});
  std::array<double, 4> cells{};
  for (std::size_t row = 0; row * row_size < file.content.size(); ++row) {
    for (std::size_t k = 0; k < cells.size(); ++k)
      cells[k] = little_endian(file.content.substr(row * row_size + k * sizeof(double), sizeof(double)));
    rows.add(std::span<const double>(cells), row + 1);
  }
  Packing packing = rows.finish();
  if (kind == "xyzd")
    packing.notes.push_back(
        "what stands beside the file (packing.nfo) is not read: give its box as [packing] box and "
        "periodic, and scale its diameters first where it says so");
  return packing;
}

}  // namespace

bool holds_doubles(const std::string& path, std::string_view bytes, const PackingOptions& options) {
  return !kind_of(path, bytes, options).empty();
}

PackingFormat doubles_format() {
  return {"rows of four doubles", recognises, read, true};
}

}  // namespace superstep
