#pragma once
/// What readers of pore networks share.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "network/files/read_network.hpp"

namespace superstep {

struct Pore {
  double capacity = 1;
  std::size_t line = 0;  ///< of the file; 0 = it has none
};

struct Throat {
  std::int64_t i = 0, j = 0;  ///< pores, counted from 0
  double conductance = 0;
  std::size_t line = 0;  ///< of the file; 0 = it has none
};

/// Makes a graph of `network` out of pores and throats, parallel ones summed with a note. Throws InputError.
void join_pores(const std::string& file, std::span<const Pore> pores, std::span<const Throat> throats,
                PoreNetwork& network);

/// "net | property | pore | diameter" as "net.property.pore.diameter".
[[nodiscard]] std::string with_dots(std::string name);

/// Number of the one of `names` that is called `wanted`, with or without what OpenPNM puts before it, bars
/// standing for dots. Nothing where there is none. Throws InputError, beginning with `where`, where several
/// could be meant and none is called exactly that.
[[nodiscard]] std::optional<std::size_t> find_name(std::span<const std::string> names,
                                                   const std::string& wanted, const std::string& where);

/// A pore network in VTK XML: lines are throats, their data the columns of throats, data of points those of
/// pores. Names may say "throat." or "pore." or not, and have the network's before them.
[[nodiscard]] PoreNetwork pores_of_vtk(const std::string& file, const std::string& text,
                                       const std::string& conductance, const std::string& capacity);

}  // namespace superstep
