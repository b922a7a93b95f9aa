#pragma once
/// The tables of a case with moving particles.

#include "core/text/toml.hpp"
#include "dynamics/model.hpp"
#include "dynamics/particles.hpp"

namespace superstep::dynamics {

/// Laws, particles and initial state of a case.
struct ModelInput {
  Model model;
  Particles particles;
  State state;
};

/// Reads [material], [thermal], [electric] and [dynamics] with all its tables but [dynamics.stepping].
/// Throws InputError with file, line, value, rule and way out; overlapping or misplaced particles, walls that
/// would cross and a placement that finds no room are such errors.
///   t_end [s]  that the phases have to reach
[[nodiscard]] ModelInput read_model(TomlTable& root, double t_end);

}  // namespace superstep::dynamics
