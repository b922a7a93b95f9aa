#pragma once
/// What the Joule heat costs, so that methods that evaluate it at different intervals can be compared.

#include <cstddef>
#include <optional>

#include "case/scene.hpp"
#include "core/state_vector.hpp"

namespace superstep {

/// Times substeps of a scene in which current heats and nothing leads back: of both fields with the heat, and
/// of the two halves without.
class JouleCost {
 public:
  /// The scene must outlive it.
  explicit JouleCost(const Scene& scene);
  /// CPU time that the heat adds to a substep of both fields [s], one sample; empty for other scenes.
  [[nodiscard]] std::optional<double> sample();

 private:
  [[nodiscard]] double seconds_whole(std::size_t times);
  [[nodiscard]] double seconds_halves(std::size_t times);

  Rhs& rhs_;
  OneWayCoupling* halves_;
  StateVector state_, next_, rate_;
};

}  // namespace superstep
