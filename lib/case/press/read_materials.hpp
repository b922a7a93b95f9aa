#pragma once
/// [material] or [[materials]] of a press.

#include <string>
#include <vector>

#include "core/text/toml.hpp"

namespace superstep::dynamics {

struct PressMaterial {
  std::string name;                            ///< empty where there is one
  double density = 0;                          ///< kg/m3
  double specific_heat = 0, conductivity = 0;  ///< J/(kg K), W/(m K)
  double electric_conductivity = 0;            ///< S/m; 0 without [electric]
  double hardness = 1;                         ///< contact stiffness over [dynamics.contact]'s
  double share = 0;                            ///< of generated particles, by number
};

/// One without a name, or several. [thermal] and [electric] must then leave to them what each has of its own.
[[nodiscard]] std::vector<PressMaterial> read_press_materials(TomlTable& root, bool electric);

}  // namespace superstep::dynamics
