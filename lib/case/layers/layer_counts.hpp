#pragma once
/// What has to be known of all layers before anybody can build its own.

#include "case/layers/layered_scene.hpp"

namespace superstep {

struct LayerFacts {
  double low = 0, high = 0;  ///< range of initial and fixed values
  bool radiates = false, convects = false;
  std::int64_t fixed = 0;                   ///< nodes
  std::vector<std::string> feeding_nobody;  ///< places of the case
};

/// Counts rows, and finds what the layers have together. Collective. Throws InputError, on all processes the
/// same.
[[nodiscard]] LayerFacts count_layers(LayeredNodes& nodes, Communicator& among);

/// The node that a row belongs to; 0 for the first row, the number of nodes for the one behind the last.
/// Collective; processes may ask for different ones.
[[nodiscard]] std::int64_t node_of_row(LayeredNodes& nodes, std::int64_t row, Communicator& among);

}  // namespace superstep
