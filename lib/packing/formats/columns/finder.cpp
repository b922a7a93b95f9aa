#include "packing/formats/columns/finder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/suggest.hpp"

namespace superstep {
namespace {

/// Of computes, fixes, variables and custom properties. Source: LAMMPS manual, `dump custom`.
bool begins_an_attribute(std::string_view written) {
  for (const char* prefix : {"c_", "d_", "d2_", "f_", "i_", "i2_", "v_"})
    if (written.starts_with(prefix)) return true;
  return false;
}

}  // namespace

ColumnFinder::ColumnFinder(std::span<const std::string> names, const ColumnRules& rules, std::string place,
                           std::string header)
    : written_(names), rules_(rules), place_(std::move(place)), header_(std::move(header)) {
  for (const auto& name : names)
    plain_.push_back(rules_.lammps && begins_an_attribute(name) ? PlainName{name, {}, {}} : plain_name(name));
  for (std::size_t k = 0; k < names.size(); ++k)
    for (std::size_t j = 0; j < k; ++j) {
      if (names[k].empty() || names[j] != names[k] || is_of_format(j) || is_of_format(k)) continue;
      repeated_.emplace_back(j, k);
      plain_[k] = {};
      break;
    }
}

bool ColumnFinder::is_of_format(std::size_t column) const {
  return rules_.positions_at && column >= *rules_.positions_at && column < *rules_.positions_at + 3;
}

std::vector<std::size_t> ColumnFinder::all(const std::string& name) const {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < plain_.size(); ++k)
    if (plain_[k].name == name && !is_of_format(k)) out.push_back(k);
  return out;
}

void ColumnFinder::require_one(const std::vector<std::size_t>& columns) const {
  if (columns.size() < 2) return;
  throw InputError(fmt::format(
      "{}: columns '{}' and '{}' of {} mean the same, since upper and lower case, signs and units "
      "are no part of a name; rename the one that is not meant, or remove it",
      place_, written_[columns[0]], written_[columns[1]], header_));
}

std::size_t ColumnFinder::find(const std::vector<std::string>& candidates) const {
  for (const auto& candidate : candidates)
    if (const auto found = all(candidate); !found.empty()) {
      require_one(found);
      return found.front();
    }
  return SphereColumns::none;
}

SphereColumns::Axes ColumnFinder::find_axes(const CoordinateNames& names) const {
  SphereColumns::Axes axes{SphereColumns::none, SphereColumns::none, SphereColumns::none};
  std::array<std::vector<std::size_t>, 3> found;
  const std::size_t dimensions = rules_.flat ? 2 : 3;
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    found[axis] = all(names[axis]);
    if (!found[axis].empty()) axes[axis] = found[axis].front();
  }
  if (is_complete(axes))
    for (const auto& columns : found) require_one(columns);
  return axes;
}

bool ColumnFinder::is_complete(const SphereColumns::Axes& axes) const {
  return std::count(axes.begin(), axes.end(), SphereColumns::none) == (rules_.flat ? 1 : 0);
}

std::optional<double> ColumnFinder::unit(std::size_t column) const {
  return column == SphereColumns::none ? std::nullopt : plain_[column].unit;
}

std::string ColumnFinder::hint(const std::string& name, const std::vector<std::string>& candidates) const {
  for (std::size_t k = 0; k < plain_.size(); ++k) {
    const std::string bare = plain_[k].unknown_unit.empty() ? "" : name_without_unit(written_[k]);
    if (std::find(candidates.begin(), candidates.end(), bare) != candidates.end())
      return fmt::format("; '{}' states the unit '{}', which is none of m, cm, mm, um, nm and \xC3\x85",
                         written_[k], plain_[k].unknown_unit);
  }
  const std::string wanted[] = {name};
  for (const auto& other : written_)
    if (other.size() > 2 && !nearest_by_spelling(lower_case(other), wanted).empty())
      return fmt::format("; is '{}' meant?", other);
  return {};
}

void ColumnFinder::missing(const std::string& name, const std::vector<std::string>& candidates) const {
  throw InputError(
      fmt::format("{}: column '{}' is missing from {}; a packing needs x y z and radius or diameter "
                  "(and id, type or material if there are several){}; add it",
                  place_, name, header_, hint(name, candidates)));
}

}  // namespace superstep
