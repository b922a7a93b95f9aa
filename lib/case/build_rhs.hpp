#pragma once
/// From the fields of a scene to its right-hand side: the one place that decides what a scene does not need.

#include <string>

#include "case/scene.hpp"

namespace superstep {

/// How the fields act on each other, `[coupling]` of a case.
struct Coupling {
  bool joule_heat = false;
  double settle_tolerance = 0;  ///< of the potential's span; 0 = it is stepped to the end
  double resolve_change = 0;    ///< steady potential: see NonlinearInput
};

/// Assigns roles, builds the networks and the right-hand side, sets the initial state and the ranges, and
/// lists what is skipped. Throws InputError, beginning with `where`.
void build_rhs(const std::string& where, const Coupling& coupling, Scene& scene);

/// Where a field acts through differences alone, its values are counted from the one nearest to 0: digits
/// that all values share would be lost in every difference, and 20 and 293.15 would not give the same steps.
///   low, high  range of its values
[[nodiscard]] double origin_of(double low, double high) noexcept;

/// What the scene's right-hand side was built from, a NonlinearRhs that solves for no potential. Points into
/// the scene.
[[nodiscard]] NonlinearInput nonlinear_input(const Scene& scene);

}  // namespace superstep
