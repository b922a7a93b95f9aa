#include "case/packed/read_lattice.hpp"

#include <fmt/format.h>

#include "packing/pack_checks.hpp"

namespace superstep {

Lattice read_lattice(TomlTable& packing, double unit) {
  for (const char* key :
       {"generator", "length_unit", "units", "periodic", "box", "cells", "spacing", "diameter", "container"})
    (void)packing.find(key);
  packing.finish();  // a misspelt key is said first: without it others would not fit together
  Lattice lattice;
  const auto cells =
      packing.require("cells", "it says how many spheres stand along x, y and z: [nx, ny, nz]");
  const auto counts = cells.array();
  if (counts.size() != lattice.cells.size()) cells.reject("it must have three whole numbers [nx, ny, nz]");
  constexpr auto most = static_cast<std::int64_t>(largest_packing);
  std::int64_t left = most;  // along the axes that follow
  for (std::size_t axis = 0; axis < counts.size(); ++axis) {
    const std::int64_t count = counts[axis].integer();
    if (count < 1) cells.reject("there must be one sphere or more along every axis");
    if (count > left) cells.reject(fmt::format("there must be at most {} spheres in all", most));
    left /= count;
    lattice.cells[axis] = count;
  }
  lattice.spacing = unit * packing.positive("spacing", "length");
  lattice.diameter = unit * packing.positive("diameter", "length");
  if (const auto rule = broken_rule(lattice); !rule.empty()) packing.find("diameter")->reject(rule);
  return lattice;
}

}  // namespace superstep
