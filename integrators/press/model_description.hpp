#pragma once
/// What a press is, in words: so that a restart can tell whether it goes on with the same one.

#include <string>

#include "dynamics/model.hpp"
#include "integrators/press/checkpoint.hpp"

namespace superstep::dynamics {

/// One line "name = value" for everything that has decided the motion up to the time t [s]: laws, walls,
/// fields and the schedule up to the phase at t, with the speed of its wall instead of its end, which may
/// still move when the wall stands. Leaves out what only the method decides (solvers, tolerances, the
/// neighbour list).
[[nodiscard]] std::string model_description(const Model& model, double t);

/// Throws InputError, with the first thing that differs, unless the checkpoint comes from this model.
///   file       [text] of the checkpoint
///   case_file  [text] that the model is from
void require_same_model(const Checkpoint& stored, const Model& model, const std::string& file,
                        const std::string& case_file);

}  // namespace superstep::dynamics
