#pragma once
/// What a method would cost on a scene: predicted, never measured while running, so that a choice is the same
/// on every machine.

#include <string>
#include <vector>

#include "integrators/costs/constants.hpp"
#include "integrators/costs/work.hpp"

namespace superstep {

/// Methods whose cost is known. `euler` stands for one evaluation of f.
enum class Family : char {
  euler,
  chebyshev,
  lanczos,
  shift_invert,
  rock,
  exprb,
  cvode_pcg,
  cvode_gmres,
  cvode_klu
};

/// SPEC of a family without its tolerance.
[[nodiscard]] std::string family_spec(Family family, Physics physics);

/// Seconds of one sweep over a network with constant coefficients.
[[nodiscard]] double sweep_seconds(const Work& work, const CostConstants& constants) noexcept;

/// CPU time of a run, preparation included [s]; infinity where a family is not for the scene or the
/// tolerance.
[[nodiscard]] double predicted_seconds(Family family, const Work& work, double rtol,
                                       const CostConstants& constants);

/// Products that Lanczos takes, over all its spaces: what counters say beside times.
[[nodiscard]] double predicted_products(const Work& work, double rtol, const CostConstants& constants);

/// CPU time as it is compared with that of others: more where the prediction is a poor one.
[[nodiscard]] double cautious_seconds(Family family, const Work& work, double rtol,
                                      const CostConstants& constants);

/// A family at the tolerance that keeps the error below the one that is asked for.
struct Candidate {
  Family family = Family::rock;
  double rtol = 0;
  double seconds = 0;
};
/// What `auto` chooses among, the cheapest first.
[[nodiscard]] std::vector<Candidate> candidates(const Work& work, double rtol,
                                                const CostConstants& constants);

/// The constants that this build chooses by.
[[nodiscard]] const CostConstants& fitted_constants() noexcept;

}  // namespace superstep
