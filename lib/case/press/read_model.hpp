#pragma once
/// The tables of a case with moving particles.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/text/toml.hpp"
#include "dynamics/model.hpp"
#include "dynamics/particles.hpp"
#include "dynamics/random_addition.hpp"

namespace superstep::dynamics {

/// Laws, particles and initial state of a case.
struct ModelInput {
  Model model;
  Particles particles;
  State state;
  std::vector<std::string> warnings;  ///< what the user of a packing file should look at
};

/// Reads [material], [thermal], [electric] and [dynamics] with all its tables but [dynamics.stepping].
/// Throws InputError with file, line, value, rule and way out; overlapping or misplaced particles, walls that
/// would cross and a placement that finds no room are such errors.
///   t_end [s]  that the phases have to reach
///   seed       of generated particles, instead of the one that the case states
///   placed     told which part of them is placed, where that takes time
[[nodiscard]] ModelInput read_model(TomlTable& root, double t_end, std::optional<std::uint64_t> seed,
                                    const Placed& placed);

}  // namespace superstep::dynamics
