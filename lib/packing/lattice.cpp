#include "packing/lattice.hpp"

namespace superstep {
namespace {

void append(const Lattice& lattice, std::int64_t id, Packing& packing) {
  const auto along = [&](std::int64_t cell) { return lattice.spacing * static_cast<double>(cell); };
  const std::int64_t nx = lattice.cells[0], ny = lattice.cells[1];
  packing.id.push_back(id);
  packing.centre.push_back({along(id % nx), along(id / nx % ny), along(id / (nx * ny))});
  packing.radius.push_back(0.5 * lattice.diameter);
  packing.material.push_back(0);
}

}  // namespace

std::string broken_rule(const Lattice& lattice) {
  if (lattice.size() == 1 || lattice.diameter < 2 * lattice.spacing) return {};
  return "it must be less than twice the spacing, or each sphere holds the centres of its neighbours";
}

Packing lattice_layers(const Lattice& lattice, std::int64_t first, std::int64_t last) {
  Packing packing;
  packing.in_order = true;
  packing.mean_diameter = lattice.diameter;
  const auto size = static_cast<std::size_t>((last - first) * lattice.layer());
  packing.id.reserve(size);
  packing.centre.reserve(size);
  packing.radius.reserve(size);
  packing.material.reserve(size);
  for (std::int64_t id = first * lattice.layer(); id < last * lattice.layer(); ++id)
    append(lattice, id, packing);
  if (first == 0 && last == lattice.cells[2]) return packing;
  Packing ends;  // two corners span all
  append(lattice, 0, ends);
  append(lattice, lattice.size() - 1, ends);
  packing.part_of = PackingPart{surface_bounds(ends), lattice.size()};
  return packing;
}

}  // namespace superstep
