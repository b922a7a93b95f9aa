#pragma once
/// What repeated timings say about a ratio, and how sure that is.

#include <span>
#include <vector>

namespace superstep {

/// A ratio with the interval that holds it with 99 % confidence, as far as the repetitions can tell.
struct RatioInterval {
  double estimate = 1, low = 1, high = 1;
  [[nodiscard]] bool above(double limit) const noexcept { return low > limit; }
  [[nodiscard]] bool below(double limit) const noexcept { return high < limit; }
};

/// Timings of two pieces of work that took turns: the k-th of each belong to the same round.
struct PairedTimings {
  std::vector<double> work, yardstick;  ///< s, > 0
  [[nodiscard]] std::size_t rounds() const noexcept { return work.size(); }
};

/// How many times longer `now.work` takes than `before.work` did, each in units of its own yardstick. Two
/// estimates, each unmoved by another kind of noise: the median over rounds of work/yardstick, and the
/// quotient of their lower quartiles; the one with the narrower interval is returned. Percentile bootstrap
/// over rounds, the same random numbers every time. Both need at least one round.
/// Source: Efron & Tibshirani (1993), An Introduction to the Bootstrap, chapter 13.
[[nodiscard]] RatioInterval slowdown(const PairedTimings& now, const PairedTimings& before);

/// The same work against itself: even rounds against odd ones. An interval that excludes 1 by far means that
/// the timings cannot be trusted. Needs at least two rounds.
[[nodiscard]] RatioInterval against_itself(const PairedTimings& timings);

}  // namespace superstep
