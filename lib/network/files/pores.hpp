#pragma once
/// What readers of pore networks share.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "network/files/read_network.hpp"

namespace superstep {

struct Throat {
  std::int64_t i = 0, j = 0;  ///< pores, counted from 0
  double conductance = 0;
  std::size_t line = 0;  ///< of the file; 0 = it has none
};

/// Makes a graph of `network` out of pores and throats, parallel ones summed with a note. Throws InputError.
void join_pores(const std::string& file, std::span<const double> capacities, std::span<const Throat> throats,
                PoreNetwork& network);

/// A pore network in VTK XML: lines are throats, their data the columns of throats, data of points those of
/// pores. Names may say "throat." or "pore." or not, and have the network's before them.
[[nodiscard]] PoreNetwork pores_of_vtk(const std::string& file, const std::string& text,
                                       const std::string& conductance, const std::string& capacity);

}  // namespace superstep
