#pragma once
/// The keys `rtol` and `step`, which mean the same for every method that takes them.

#include <array>
#include <string>

#include "core/text/options.hpp"

namespace superstep {

/// Error that a run may have at its output times (rms), relative to the span of the field: its largest minus
/// its smallest value over all nodes and the whole run.
[[nodiscard]] inline OptionKey tolerance_key(const std::string& fallback) {
  return {.name = "rtol",
          .min = 1e-14,
          .max = 0.5,
          .fallback = fallback,
          .meaning = "error allowed at every output time (rms), relative to the span of the field"};
}

[[nodiscard]] inline OptionKey fixed_step_key() {
  return {.name = "step",
          .min = 0,
          .min_open = true,
          .unit = "s",
          .meaning = "fixed step instead of a controlled one"};
}

/// That step [s]; 0 = steps follow rtol. Throws UsageError where both are given.
[[nodiscard]] inline double fixed_step_of(const Options& options) {
  static const std::array<std::string, 2> one_of = {"rtol", "step"};
  options.at_most_one_of(one_of);
  return options.given("step").value_or(0);
}

}  // namespace superstep
