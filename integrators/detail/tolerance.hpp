#pragma once
/// The key `rtol`, which means the same for every method that takes it.

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

}  // namespace superstep
