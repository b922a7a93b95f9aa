#pragma once
/// The laws of a press and the numbers in them.

#include <array>
#include <string>
#include <vector>

#include "dynamics/laws/bond_law.hpp"
#include "dynamics/laws/contact_law.hpp"
#include "dynamics/laws/drag.hpp"
#include "dynamics/laws/saturation.hpp"
#include "dynamics/laws/schedule.hpp"
#include "dynamics/walls.hpp"

namespace superstep::dynamics {

/// How current finds its way.
enum class CurrentModel : char {
  none,       ///< there is no electric field
  averaging,  ///< particle currents J, each the area-weighted mean of its neighbours (Zohdi 2014, eq. 42)
  potential,  ///< potentials and pipe conductances, as in a network of resistors
};
enum class CurrentSolver : char {
  jacobi,     ///< as printed (Zohdi 2014, eq. 43)
  conjugate,  ///< conjugate gradients
  direct,     ///< Cholesky factorization
};

struct ThermalLaw {
  double conductivity = 0;                            ///< kappa [W/(m K)], >= 0
  double specific_heat = 1;                           ///< C [J/(kg K)], > 0
  std::array<double, wall_count> wall_temperature{};  ///< K
  bool walls_conduct = true;                          ///< heat flows between walls and what touches them
};

struct ElectricLaw {
  CurrentModel model = CurrentModel::none;
  CurrentSolver solver = CurrentSolver::conjugate;
  double conductivity = 1;       ///< sigma [S/m], > 0
  Saturation saturation;         ///< of the conductivity
  double absorption = 1;         ///< a, 0 to 1
  double tolerance = 1e-10;      ///< of iterative solvers, relative
  bool hold_temperature = true;  ///< what touches an electrified wall takes its temperature
};

struct Model {
  Box box;
  Schedule schedule;
  ContactLaw contact, wall;
  BondLaw bond;
  DragLaw drag;
  double gravity = 9.81;  ///< m/s2, along -z
  ThermalLaw thermal;
  ElectricLaw electric;
  double skin = 0;                          ///< of the neighbour list [m], > 0
  std::vector<std::string> material_names;  ///< empty = one material without a name
};

/// Whether what touches an electrified wall takes its temperature.
[[nodiscard]] inline bool holds_temperatures(const Model& model) noexcept {
  return model.electric.model != CurrentModel::none && model.electric.hold_temperature;
}

}  // namespace superstep::dynamics
