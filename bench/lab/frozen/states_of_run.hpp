#pragma once
/// States at which a scene is frozen: a few along an accurate run of it.

#include <string>
#include <vector>

#include "case/scene.hpp"

namespace superstep {

struct StateOfRun {
  double part = 0;  ///< of t_end [-]
  double time = 0;  ///< s
  std::vector<double> y;
};

struct StatesOfRun {
  std::vector<StateOfRun> states;
  std::vector<double> spans;       ///< [fields] K or V
  std::vector<std::string> notes;  ///< what could not be had, and why
};

/// SPEC of the run that states are taken from.
inline constexpr const char* method_of_states = "cvode:rtol=1e-6";

/// The start, and the states at 10, 50 and 100 % of t_end; the start alone where the Jacobian is constant. A
/// run that fails gives the states before it did.
[[nodiscard]] StatesOfRun states_along_run(const Scene& scene);

}  // namespace superstep
