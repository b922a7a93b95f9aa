#pragma once
/// How a press of moving particles is stepped, as a case states it.

#include <algorithm>
#include <string>

namespace superstep::dynamics {

/// Bounds of the change from one step to the next; Zohdi (2014) has none.
struct StepBounds {
  double growth = 2;             ///< largest factor, > 1
  double shrink = 0.1;           ///< smallest factor, in (0, 1)
  double rejected_shrink = 0.9;  ///< a restarted step shrinks at least to this part

  [[nodiscard]] double after_success(double factor) const noexcept {
    return std::clamp(factor, shrink, growth);
  }
  [[nodiscard]] double after_failure(double factor) const noexcept {
    return std::clamp(factor, shrink, rejected_shrink);
  }
};

/// How time is stepped.
struct SteppingSettings {
  enum class Scheme : char {
    staggered,  ///< phi rule by staggered fixed-point iteration, adaptive (Zohdi 2014, Algorithm 1)
    plain,      ///< semi-implicit Euler, one force evaluation a step, at a part of its stability limit
  };
  Scheme scheme = Scheme::staggered;
  enum class Control : char {
    steady,  ///< aims at half of the wanted iterations, so that hardly a step is made again; jumps are
             ///< located
    paper,   ///< aims at all of them (Zohdi 2014, Algorithm 1); whatever jumps does so at the end of a step
  };
  Control control = Control::steady;
  double phi = 0.5;                     ///< 0 to 1; 0.5 is second order
  int iterations = 10;                  ///< K_d, wanted iterations of a step, >= 2
  double tolerance_position = 5e-4;     ///< TOL_r
  double tolerance_temperature = 5e-4;  ///< TOL_T
  double power = 2;                     ///< p of the contraction ~ h^p
  double first_step = 0.005;            ///< s
  double largest_step = 0.005;          ///< dt_lim [s]
  double smallest_step = 1e-9;          ///< s; a step that has to become smaller is a failure
  StepBounds bounds;
  double fraction = 0.5;  ///< plain scheme: of its stability limit
  /// SPEC of the integrator that takes the temperatures over each step once the motion has converged; empty =
  /// the phi rule inside the iteration.
  std::string thermal_integrator;
};

/// Throws InputError for a setting that is out of range; the SPEC is not looked at.
void check_settings(const SteppingSettings& settings);

}  // namespace superstep::dynamics
