#include "packing/formats/plausible_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/text/number.hpp"

namespace superstep {
namespace {

std::size_t place_of(const AtomLayout& layout, const char* name) {
  return static_cast<std::size_t>(std::find(layout.columns.begin(), layout.columns.end(), name) -
                                  layout.columns.begin());
}

}  // namespace

PlausibleLayout::PlausibleLayout(std::optional<Cell> cell, std::int64_t types, bool hybrid_only)
    : cell_(cell && cell->volume() > 0 ? cell : std::nullopt), types_(types), hybrid_only_(hybrid_only) {}

void PlausibleLayout::add_candidates(std::size_t columns) {
  for (auto& layout : atom_layouts(columns, hybrid_only_)) {
    const auto place = [&](const char* name) { return place_of(layout, name); };
    candidates_.push_back(
        {layout, place("id"), place("type"), place("x"), place("diameter"), place("density")});
  }
}

void PlausibleLayout::look_at(std::span<const std::string_view> row) {
  if (width_ == 0) {
    constexpr std::size_t image_flags = 3;
    width_ = row.size();
    add_candidates(width_);
    if (width_ > image_flags) add_candidates(width_ - image_flags);
  }
  ++rows_;
  for (auto& candidate : candidates_)
    if (row.size() == width_ && accepts(candidate, row)) ++candidate.fits;
}

bool PlausibleLayout::accepts(const Candidate& candidate, std::span<const std::string_view> row) const {
  const auto type = parse_whole_number(row[candidate.type]);
  if (!parse_whole_number(row[candidate.id]) || !type || *type < 1 || (types_ > 0 && *type > types_))
    return false;
  for (std::size_t k = candidate.layout.columns.size(); k < row.size(); ++k)
    if (!parse_whole_number(row[k])) return false;  // image flags
  const auto diameter = parse_number(row[candidate.diameter]), density = parse_number(row[candidate.density]);
  const std::size_t at = candidate.x;
  const auto x = parse_number(row[at]), y = parse_number(row[at + 1]), z = parse_number(row[at + 2]);
  if (!diameter || !density || !x || !y || !z || !(*diameter > 0) || !(*density > 0)) return false;
  return !cell_ || is_inside(*diameter, {*x, *y, *z});
}

bool PlausibleLayout::is_inside(double diameter, Vec3 centre) const {
  const Vec3 part = cell_->fraction(centre);
  double largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double height = cell_->height(axis), at = axis == 0 ? part.x : axis == 1 ? part.y : part.z;
    if (height * std::max(-at, at - 1) > diameter) return false;
    largest = std::max(largest, height);
  }
  return diameter <= largest;
}

AtomLayout PlausibleLayout::choose(const std::string& place) const {
  if (candidates_.empty()) return atom_layout(hybrid_only_ ? "hybrid sphere" : "sphere", place);
  constexpr std::size_t few = 10;  // of a hundred rows: an order that fits no more is none
  std::vector<const AtomLayout*> fitting, nearly, all;
  for (const auto& candidate : candidates_) {
    all.push_back(&candidate.layout);
    if (candidate.fits == rows_) fitting.push_back(&candidate.layout);
    if (100 * candidate.fits > few * rows_) nearly.push_back(&candidate.layout);
  }
  if (fitting.size() == 1) return *fitting.front();
  // Something is wrong with a row, and its reader says what.
  if (fitting.empty() && nearly.size() == 1) return *nearly.front();
  if (all.size() == 1) return *all.front();
  std::vector<std::string> orders;
  for (const auto* layout : fitting.empty() ? all : fitting)
    orders.push_back(fmt::format("atom_style = \"{}\" ({})", layout->style, fmt::join(layout->columns, " ")));
  throw InputError(fmt::format(
      "{}: section 'Atoms' does not name its style, and {} makes sense of its rows of {} columns: declare "
      "the style or "
      "the columns in [packing], as in {}",
      place, fitting.empty() ? "no order of columns that is known here" : "more than one order of columns",
      width_, fmt::join(orders, ", or ")));
}

}  // namespace superstep
