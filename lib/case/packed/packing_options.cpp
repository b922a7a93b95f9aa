#include "case/packed/packing_options.hpp"

#include <algorithm>
#include <array>

#include "core/text/suggest.hpp"
#include "packing/units.hpp"

namespace superstep {
namespace {

constexpr std::array<const char*, 16> axes = {"x",  "y",   "z",   "xy",  "xz",  "yx",  "yz",  "zx",
                                              "zy", "xyz", "xzy", "yxz", "yzx", "zxy", "zyx", "none"};

std::string one_of(const TomlValue& value, std::vector<std::string> words) {
  const std::string word = value.string();
  if (std::find(words.begin(), words.end(), word) == words.end())
    value.reject("it must be one of those that are known" + suggestion(word, words));
  return word;
}

Vec3 corner(TomlTable& table, const char* key) {
  const auto value = table.require(key, "it must be [x, y, z]");
  const auto numbers = value.numbers();
  if (numbers.size() != 3) value.reject("it must have three numbers [x, y, z]");
  return {numbers[0], numbers[1], numbers[2]};
}

Cell read_box(TomlTable table) {
  const Vec3 low = corner(table, "min"), high = corner(table, "max");
  const auto max = table.find("max");
  if (!(high.x > low.x && high.y > low.y && high.z > low.z))
    max->reject("it must lie above min along every axis");
  table.finish();
  return box_cell(low, high);
}

}  // namespace

PackingOptions read_packing_options(TomlTable& packing) {
  PackingOptions options;
  options.place = packing.where();
  if (const auto unit = packing.find("length_unit")) {
    options.length_unit = length_unit(unit->string(), unit->where());
    options.place = unit->where();
  }
  if (const auto units = packing.find("units")) {
    auto words = unit_styles();
    words.insert(words.begin(), "auto");
    options.units = one_of(*units, std::move(words));
  }
  if (const auto periodic = packing.find("periodic")) {
    options.periodic = periodic->string();
    if (options.periodic != "auto" && std::find(axes.begin(), axes.end(), options.periodic) == axes.end())
      periodic->reject("it must be \"auto\", \"none\", or axes such as \"x\", \"xy\", \"xyz\"");
  }
  if (auto box = packing.table("box")) options.box = read_box(*box);
  if (const auto format = packing.find("format")) options.format = one_of(*format, {"auto", "xyzd", "xyzr"});
  if (const auto order = packing.find("order"))
    options.in_layers = one_of(*order, {"bandwidth", "layers"}) == "layers";
  if (const auto style = packing.string("atom_style")) options.atom_style = *style;
  if (const auto columns = packing.find("columns")) {
    options.columns = columns->strings();
    if (options.columns.empty()) columns->reject("it must name every column of the file");
  }
  return options;
}

}  // namespace superstep
