#pragma once
/// About how long a press would take, said before it runs.

#include "case/press/press.hpp"

namespace superstep {

struct PressForecast {
  double step = 0;   ///< s, about the mean over the run
  double steps = 0;  ///< about so many
  double cpu = 0;    ///< s, about
};

/// sqrt(m/k) of two equal particles at 10 % overlap, cold: the shortest of all particles [s]; 0 where none
/// repels.
[[nodiscard]] double pair_oscillation(const Press& press);

/// The step is what the scheme allows where the bed stands, if its particles touch; else a sixth of a pair's
/// oscillation, which is what the shipped presses that pour their particles take in the mean; in either case
/// at most `largest_step`. A particle and step cost a microsecond of one core, a third of it under the plain
/// scheme. Beside the shipped presses steps and times come out within a factor of three.
[[nodiscard]] PressForecast forecast_press(const Press& press);

}  // namespace superstep
