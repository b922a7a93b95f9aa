#include "packing/formats/sphere_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/number.hpp"
#include "packing/formats/inside_cell.hpp"
#include "packing/units.hpp"

namespace superstep {
namespace {

constexpr auto none = SphereColumns::none;
constexpr double written_digits = 1e-3;  // relative; what stands twice is often written with few digits

std::optional<StatedUnit> unit_of(const SphereLayout& layout, const SphereColumns& columns) {
  if (!columns.unit) return layout.unit;
  return StatedUnit{*columns.unit,
                    fmt::format("{}, as the names of the columns say", length_unit_name(*columns.unit))};
}

/// A finite number, else nothing.
std::optional<double> finite(std::string_view cell) {
  return parse_number(cell);
}
std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<std::int64_t> whole(std::string_view cell) {
  return parse_whole_number(cell);
}
std::optional<std::int64_t> whole(double value) {
  constexpr double largest = 9007199254740992.0;  // 2^53
  if (!(std::abs(value) <= largest) || value != std::nearbyint(value)) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

std::string shown(std::string_view cell) {
  return in_quotes(cell);
}
std::string shown(double value) {
  return fmt::format("'{}'", value);
}

std::string word_of(double value) {
  return fmt::format("{}", value);
}

/// Text of a quoted cell, in which a doubled quote stands for one.
std::string with_single_quotes(std::string_view cell) {
  std::string out(cell);
  for (std::size_t k = out.find("\"\""); k != std::string::npos; k = out.find("\"\"", k + 1)) out.erase(k, 1);
  return out;
}

/// NaN for what a broken run or a spreadsheet writes where there is no number; nothing for text.
std::optional<double> value_or_gap(std::string_view cell) {
  if (const auto value = parse_number(cell)) return value;
  std::string word = lower_case(cell);
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.erase(0, 1);
  if (word.empty() || word == "nan" || word == "inf" || word == "na" || word == "infinity")
    return std::numeric_limits<double>::quiet_NaN();
  return std::nullopt;
}
std::optional<double> value_or_gap(double value) {
  return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

SphereRows::SphereRows(const PackingFile& file, SphereLayout layout)
    : layout_(std::move(layout)),
      path_(file.path),
      columns_(find_sphere_columns(layout_.names, layout_.rules, layout_.place, layout_.header)),
      unit_(choose_unit(file, unit_of(layout_, columns_), head_)),
      builder_(file.path, unit_, layout_.row),
      is_text_(columns_.attributes.size(), 0) {
  for (const auto column : columns_.attributes) attributes_.push_back({layout_.names[column], {}});
  if (columns_.is_scaled() && !layout_.cell)
    throw InputError(
        fmt::format("{}: positions are parts of a box, and the file states none; write its bounds, or "
                    "positions x y z",
                    layout_.place));
}

template <class Value>
double SphereRows::number(std::span<const Value> cells, std::size_t column, std::size_t line) const {
  const auto value = finite(cells[column]);
  if (!value)
    throw InputError(fmt::format("{}: column '{}' is {}; it must be a finite decimal number such as 1.5e-3",
                                 builder_.where(line), layout_.names[column], shown(cells[column])));
  return *value;
}

template <class Value>
std::int64_t SphereRows::id(std::span<const Value> cells, std::size_t line) const {
  if (columns_.id == none) return static_cast<std::int64_t>(builder_.size());
  const auto value = whole(cells[columns_.id]);
  if (!value)
    throw InputError(fmt::format("{}: column '{}' is {}; it must be an integer", builder_.where(line),
                                 layout_.names[columns_.id], shown(cells[columns_.id])));
  return *value;
}

template <class Value>
double SphereRows::radius(std::span<const Value> cells, std::size_t line) const {
  if (columns_.radius == none) return columns_.diameter_unit * 0.5 * number(cells, columns_.diameter, line);
  const double value = number(cells, columns_.radius, line), size = columns_.radius_unit * value;
  if (columns_.diameter == none) return size;
  const double diameter = number(cells, columns_.diameter, line);
  if (std::abs(columns_.diameter_unit * diameter - 2 * size) > written_digits * 2 * std::abs(size))
    throw InputError(
        fmt::format("{}: radius is {} and diameter {} in columns '{}' and '{}'; the one must be half of the "
                    "other: correct it, or remove the wrong column",
                    builder_.where(line), value, diameter, layout_.names[columns_.radius],
                    layout_.names[columns_.diameter]));
  return size;
}

template <class Value>
Vec3 SphereRows::point(std::span<const Value> cells, const SphereColumns::Axes& axes,
                       std::size_t line) const {
  return {number(cells, axes[0], line), number(cells, axes[1], line),
          axes[2] == none ? 0.0 : number(cells, axes[2], line)};
}

/// Under two kinds of names stand the same numbers, or nobody can know which are meant.
template <class Value>
void SphereRows::require_one_position(std::span<const Value> cells, Vec3 centre, double size,
                                      std::size_t line) const {
  if (columns_.second_position[0] == none) return;
  const Vec3 other = columns_.second_unit * point(cells, columns_.second_position, line);
  if (norm(other - centre) <= written_digits * (norm(centre) + size)) return;
  const auto names = [&](const SphereColumns::Axes& axes) {
    std::string out;
    for (const std::size_t column : axes)
      if (column != none) out += fmt::format("{}'{}'", out.empty() ? "" : " ", layout_.names[column]);
    return out;
  };
  throw InputError(
      fmt::format("{}: the position of {} is not that of {}; remove or rename the columns that are no "
                  "positions",
                  builder_.where(line), names(columns_.position), names(columns_.second_position)));
}

template <class Value>
void SphereRows::require_same_again(std::span<const Value> cells, std::size_t line) const {
  for (const auto& [first, again] : columns_.repeated) {
    if (cells[first] == cells[again]) continue;
    const auto a = finite(cells[first]), b = finite(cells[again]);
    if (a && b ? *a == *b : !a && !b && std::is_same_v<Value, double>) continue;  // 1 and 1.0, nan and nan
    throw InputError(fmt::format("{}: column '{}' stands twice in {}, as {} and as {}; keep the right one",
                                 builder_.where(line), layout_.names[first], layout_.header,
                                 shown(cells[first]), shown(cells[again])));
  }
}

void SphereRows::set_material(std::string_view name, std::size_t line) {
  if (name.empty())
    throw InputError(
        fmt::format("{}: column '{}' is ''; it must name a material in every row, or be left out",
                    builder_.where(line), layout_.names[columns_.material]));
  const auto type =
      columns_.material_is_number && !parse_integer(name) ? parse_whole_number(name) : std::nullopt;
  if (type)
    builder_.set_material(std::to_string(*type));  // 2.0 and 2 are one type
  else
    builder_.set_material(with_single_quotes(name));
}

template <class Value>
void SphereRows::add_attributes(std::span<const Value> cells) {
  for (std::size_t k = 0; k < attributes_.size(); ++k) {
    if (is_text_[k]) continue;
    const auto value = value_or_gap(cells[columns_.attributes[k]]);
    if (value) {
      attributes_[k].value.push_back(*value);
    } else {
      is_text_[k] = 1;
      attributes_[k].value = {};
    }
  }
}

template <class Value>
void SphereRows::add_row(std::span<const Value> cells, std::size_t line) {
  if (!columns_.repeated.empty()) require_same_again(cells, line);
  Vec3 centre = point(cells, columns_.position, line);
  if (columns_.is_scaled()) centre = layout_.cell->point(centre);
  const double size = radius(cells, line);
  require_one_position(cells, centre, size, line);
  builder_.add(line, id(cells, line), centre, size);
  if (columns_.material != none) {
    if constexpr (std::is_same_v<Value, double>)
      set_material(word_of(cells[columns_.material]), line);
    else
      set_material(cells[columns_.material], line);
  }
  add_attributes(cells);
}

void SphereRows::add(std::span<const std::string_view> cells, std::size_t line) {
  add_row(cells, line);
}

void SphereRows::add(std::span<const double> cells, std::size_t line) {
  add_row(cells, line);
}

Cell SphereRows::cell_in_metres() const {
  Cell cell = *layout_.cell;
  cell.origin = unit_ * cell.origin;
  for (auto& edge : cell.edge) edge = unit_ * edge;
  return cell;
}

void SphereRows::note_columns(Packing& packing) const {
  std::vector<std::string> kept, dropped;
  for (std::size_t k = 0; k < attributes_.size(); ++k) {
    (is_text_[k] ? dropped : kept).push_back(attributes_[k].name);
    if (const auto word = likely_misspelling(attributes_[k].name); !word.empty() && columns_.material == none)
      packing.warnings.push_back(fmt::format("{}: column '{}' is kept as an attribute; is '{}' meant?", path_,
                                             attributes_[k].name, word));
  }
  const auto note = [&](std::string text) { packing.notes.push_back(std::move(text)); };
  if (columns_.radius == none) note(fmt::format("column '{}' is halved", layout_.names[columns_.diameter]));
  if (columns_.id == none) note("no ids: particles are numbered 0, 1, 2, ... in the order of the file");
  if (columns_.material != none)
    note(fmt::format("column '{}' is the material", layout_.names[columns_.material]));
  for (const auto& [first, again] : columns_.repeated)
    note(fmt::format("column '{}' stands twice, with the same values", layout_.names[first]));
  if (columns_.is_scaled()) note("positions are parts of the box");
  if (columns_.is_unwrapped())
    note("positions are unwrapped: put back into the box along the sides that the file calls periodic");
  if (layout_.rules.flat) note("two dimensions: discs are read as spheres with z = 0");
  if (!kept.empty()) note(fmt::format("kept as attributes: {}", fmt::join(kept, ", ")));
  if (!dropped.empty()) note(fmt::format("left out, since they hold text: {}", fmt::join(dropped, ", ")));
  if (!columns_.row_numbers.empty()) note("a column without a name is left out: row numbers");
}

Packing SphereRows::finish() {
  if (columns_.material_is_number) builder_.drop_single_material();
  const std::vector<std::size_t> lines = builder_.lines();
  Packing packing = builder_.finish();
  packing.length_unit = unit_;
  packing.unit_style = std::move(head_.unit_style);
  packing.columns_place = layout_.place;
  packing.notes = std::move(head_.notes);
  packing.warnings = std::move(head_.warnings);
  note_columns(packing);
  for (std::size_t k = 0; k < attributes_.size(); ++k)
    if (is_text_[k])
      packing.text_columns.push_back(std::move(attributes_[k].name));
    else
      packing.attributes.push_back(std::move(attributes_[k]));
  if (!layout_.cell) return packing;
  packing.cell = cell_in_metres();
  if (layout_.cell_binds) require_inside_cell(packing, columns_.is_unwrapped(), path_, lines);
  // Now, since the user may say that the box is open: the sides that the file calls periodic are then cut.
  if (columns_.is_unwrapped() && packing.cell->is_periodic() && packing.cell->volume() > 0)
    for (auto& centre : packing.centre) centre = packing.cell->wrapped(centre);
  return packing;
}

}  // namespace superstep
