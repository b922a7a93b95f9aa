#include "packing/formats/vtk/vtk_array.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "core/error.hpp"
#include "packing/formats/sphere_rows.hpp"

namespace superstep {
namespace {

using Kind = VtkType::Kind;

constexpr std::array<std::pair<std::string_view, VtkType>, 29> types = {{
    {"Int8", {1, Kind::signed_integer}},
    {"UInt8", {1, Kind::unsigned_integer}},
    {"Int16", {2, Kind::signed_integer}},
    {"UInt16", {2, Kind::unsigned_integer}},
    {"Int32", {4, Kind::signed_integer}},
    {"UInt32", {4, Kind::unsigned_integer}},
    {"Int64", {8, Kind::signed_integer}},
    {"UInt64", {8, Kind::unsigned_integer}},
    {"Float32", {4, Kind::floating}},
    {"Float64", {8, Kind::floating}},
    {"char", {1, Kind::signed_integer}},
    {"unsigned_char", {1, Kind::unsigned_integer}},
    {"signed_char", {1, Kind::signed_integer}},
    {"short", {2, Kind::signed_integer}},
    {"unsigned_short", {2, Kind::unsigned_integer}},
    {"int", {4, Kind::signed_integer}},
    {"unsigned_int", {4, Kind::unsigned_integer}},
    {"long", {8, Kind::signed_integer}},
    {"unsigned_long", {8, Kind::unsigned_integer}},
    {"vtktypeint64", {8, Kind::signed_integer}},
    {"vtktypeuint64", {8, Kind::unsigned_integer}},
    {"vtkIdType", {4, Kind::signed_integer}},
    {"vtkidtype", {4, Kind::signed_integer}},
    {"float", {4, Kind::floating}},
    {"double", {8, Kind::floating}},
    {"vtktypeint32", {4, Kind::signed_integer}},
    {"vtktypeuint32", {4, Kind::unsigned_integer}},
    {"long_long", {8, Kind::signed_integer}},
    {"unsigned_long_long", {8, Kind::unsigned_integer}},
}};

std::uint64_t bits_at(const unsigned char* bytes, std::size_t size, bool big_endian) noexcept {
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < size; ++k) bits = bits << 8 | bytes[big_endian ? k : size - 1 - k];
  return bits;
}

double value_of(std::uint64_t bits, VtkType type) noexcept {
  if (type.kind == Kind::floating)
    return type.size == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                          : std::bit_cast<double>(bits);
  if (type.kind == Kind::unsigned_integer) return static_cast<double>(bits);
  const unsigned unused = static_cast<unsigned>(64 - 8 * type.size);
  return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
}

}  // namespace

std::optional<VtkType> vtk_type(std::string_view name) {
  for (const auto& [known, type] : types)
    if (name == known) return type;
  return std::nullopt;
}

void append_values(std::string_view bytes, VtkType type, bool big_endian, std::vector<double>& out) {
  const auto* first = reinterpret_cast<const unsigned char*>(bytes.data());
  const std::size_t count = bytes.size() / type.size;
  out.reserve(out.size() + count);
  for (std::size_t k = 0; k < count; ++k)
    out.push_back(value_of(bits_at(first + k * type.size, type.size, big_endian), type));
}

Packing packing_of_points(const PackingFile& file, const std::vector<double>& points,
                          const std::vector<VtkArray>& data) {
  SphereLayout layout{.names = {"x", "y", "z"},
                      .place = file.path,
                      .header = "the point data",
                      .rules = {.positions_at = 0},
                      .row = "point"};
  for (const auto& array : data)
    for (std::size_t c = 0; c < array.components; ++c)
      layout.names.push_back(array.components == 1 ? array.name : fmt::format("{}:{}", array.name, c));
  const std::size_t width = layout.names.size();
  SphereRows rows(file, std::move(layout));
  std::vector<double> row(width);
  for (std::size_t point = 0; 3 * point < points.size(); ++point) {
    std::size_t cell = 0;
    for (std::size_t c = 0; c < 3; ++c) row[cell++] = points[3 * point + c];
    for (const auto& array : data)
      for (std::size_t c = 0; c < array.components; ++c)
        row[cell++] = array.value[array.components * point + c];
    rows.add(std::span<const double>(row), point);
  }
  return rows.finish();
}

}  // namespace superstep
