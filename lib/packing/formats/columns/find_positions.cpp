#include "packing/formats/columns/find_positions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"

namespace superstep {
namespace {

using Axes = SphereColumns::Axes;
constexpr auto no_column = SphereColumns::none;

bool find_lammps_positions(const ColumnFinder& finder, SphereColumns& columns) {
  using Positions = SphereColumns::Positions;
  for (const auto& [ending, kind] : {std::pair{"", Positions::plain},
                                     {"u", Positions::unwrapped},
                                     {"s", Positions::scaled},
                                     {"su", Positions::scaled_unwrapped}}) {
    const std::string end = ending;
    const Axes axes = finder.find_axes({"x" + end, "y" + end, "z" + end});
    if (!finder.is_complete(axes)) continue;
    columns.position = axes;
    columns.positions = kind;
    return true;
  }
  return false;
}

/// Says which axis has no column, or that the three have names of different kinds.
[[noreturn]] void refuse_positions(const ColumnFinder& finder) {
  Axes any{no_column, no_column, no_column};
  for (const auto& names : coordinate_names()) {
    const Axes axes = finder.find_axes(names);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (any[axis] == no_column) any[axis] = axes[axis];
  }
  if (finder.is_complete(any))
    throw InputError(
        fmt::format("{}: '{}' and '{}'{} are names of different kinds, and a position is taken from one; "
                    "call its columns x y z, or Points:0 Points:1 Points:2",
                    finder.place(), finder.written(any[0]), finder.written(any[1]),
                    finder.rules().flat ? "" : fmt::format(" and '{}'", finder.written(any[2]))));
  const auto axis = static_cast<std::size_t>(std::find(any.begin(), any.end(), no_column) - any.begin());
  std::vector<std::string> candidates;
  for (const auto& names : coordinate_names()) candidates.push_back(names[axis]);
  finder.missing({"xyz"[axis]}, candidates);
}

}  // namespace

void find_positions(const ColumnFinder& finder, SphereColumns& columns) {
  if (const auto first = finder.rules().positions_at) {
    columns.position = {*first, *first + 1, *first + 2};
    return;
  }
  if (finder.rules().lammps && find_lammps_positions(finder, columns)) return;
  for (const auto& names : coordinate_names()) {
    const Axes axes = finder.find_axes(names);
    if (!finder.is_complete(axes)) continue;
    const bool is_first = columns.position[0] == no_column;
    (is_first ? columns.position : columns.second_position) = axes;
    if (!is_first || finder.rules().lammps) return;
  }
  if (columns.position[0] == no_column) refuse_positions(finder);
}

}  // namespace superstep
