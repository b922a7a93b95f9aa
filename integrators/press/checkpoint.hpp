#pragma once
/// A run on disk: everything that it needs to go on as if it had never stopped.

#include <string>
#include <vector>

#include "dynamics/particles.hpp"
#include "integrators/press/history.hpp"

namespace superstep::dynamics {

struct Checkpoint {
  Particles particles;
  State state;
  double next_step = 0;  ///< s
  std::vector<HistoryRow> history;
  std::string model = {};  ///< `model_description` of the press at that time
};

/// Binary image in the machine's number format, with a version and a checksum.
[[nodiscard]] std::string checkpoint_image(const Checkpoint& checkpoint);
/// Reads a file written from `checkpoint_image`. Throws InputError for anything else, a damaged file, or one
/// of another version.
[[nodiscard]] Checkpoint read_checkpoint(const std::string& path);

}  // namespace superstep::dynamics
