#pragma once
/// The last four stages of a ROCK4 step: they multiply the recurrence's polynomial by w and make the whole
/// step of order four for nonlinear and time-dependent right-hand sides, not only for linear ones.

#include "integrators/schemes/three_term.hpp"

namespace superstep {

/// Fills scheme.finish and the stage times c from the recurrence m, n, mt, whose product with w must have
/// order four for linear problems. The four conditions on trees other than chains, the four of chains, and
/// two nodes chosen for a small error give the ten coefficients.
/// Source of the composition: Hairer, Norsett & Wanner (1993), Solving Ordinary Differential Equations I,
/// section II.12; order conditions: ibid. section II.2.
void set_rock_finish(ThreeTermScheme& scheme);

/// Elementary weights Phi of the eight rooted trees with up to four nodes, which are 1/gamma for a step of
/// order four. Trees by their branches: 0 t, 1 [t], 2 [t,t], 3 [[t]], 4 [t,t,t], 5 [t,[t]], 6 [[t,t]],
/// 7 [[[t]]].
using ElementaryWeights = std::array<double, 8>;
/// Of the scheme's whole step, finishing procedure included.
[[nodiscard]] ElementaryWeights elementary_weights(const ThreeTermScheme& scheme);

}  // namespace superstep
