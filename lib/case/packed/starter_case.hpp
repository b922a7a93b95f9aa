#pragma once
/// A case to start from, for a packing that somebody has.

#include <optional>
#include <string>

#include "packing/packing.hpp"

namespace superstep {

struct StarterSettings {
  std::string file = {};       ///< of the packing, as the case shall name it
  char axis = 0;               ///< along which heat is led; 0 = the longest open one
  double conductivity = 1;     ///< W/(m K)
  double density = 2500;       ///< kg/m^3
  double specific_heat = 700;  ///< J/(kg K)
  std::string neck = "hertz";
  std::string length_unit = {};  ///< that the user gave; empty = none
  std::string units = "auto";    ///< the same of the unit style
  std::string periodic = "auto";
  double t_end = 1;  ///< s
  bool held_once =
      false;  ///< only the outermost particle at one end is held: layers would leave nothing free
  bool given_conductivity = false, given_density = false,
       given_specific_heat = false;  ///< else they are examples
};

/// Axis along which `starter_case` leads heat.
[[nodiscard]] char starter_axis(const Packing& packing, const StarterSettings& settings);

/// A commented case: heat from one side to the other along an axis. Where the packing is periodic along it,
/// the case cuts it open there. Necks across small gaps are added where particles only just touch.
[[nodiscard]] std::string starter_case(const Packing& packing, const StarterSettings& settings);

}  // namespace superstep
