#pragma once
/// What a caller has in memory, where a case file would name other files.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case/scene.hpp"
#include "packing/packing.hpp"

namespace superstep {

/// n spheres. Lengths are in `[packing] length_unit`, metres where the case says nothing.
struct SphereArrays {
  std::span<const double> centres;           ///< [3n] x, y, z of one after the other
  std::span<const double> radii;             ///< [n] > 0
  std::span<const std::int64_t> ids;         ///< [n], or empty: 0, 1, 2, ...
  std::vector<std::string> materials;        ///< [n] name of each one's material, or empty
  std::vector<PackingAttribute> attributes;  ///< [n] each; for `initial = { column = "name" }`
};

/// A symmetric matrix in compressed rows, Laplacian or conductances, or else a list of edges.
struct NetworkArrays {
  std::span<const double> value;            ///< [nonzeros] W/K or S
  std::span<const std::int64_t> column;     ///< [nonzeros] in any order; the same place twice is summed
  std::span<const std::int64_t> row_begin;  ///< [n+1]; empty = there are edges

  std::span<const std::int64_t> ends;   ///< [2m] the two nodes of each edge
  std::span<const double> conductance;  ///< [m] W/K or S, >= 0
  std::size_t nodes = 0;                ///< n, beside edges

  std::span<const double> capacity;  ///< [n] J/K or F, or empty: as the case says
  std::span<const double> source;    ///< [n] W or A, or empty: as the case says
  std::span<const double> initial;   ///< [n] K or V, or empty: as the case says
  std::span<const double> fixed;     ///< [n] K or V, NaN = not fixed; or empty: as the case says
};

/// All of it lives as long as the scene is being built, and no longer.
struct CaseData {
  std::optional<SphereArrays> spheres;   ///< [packing] then names neither a file nor a generator
  std::optional<NetworkArrays> network;  ///< [network] then names no files of nodes, edges or matrices
};

/// Builds the scene of a case that is parsed already, with particles or a network out of `data`. Errors name
/// arrays and positions in them, which count from 0. Throws InputError.
[[nodiscard]] Scene load_scene(TomlTable root, const CaseData& data);

}  // namespace superstep
