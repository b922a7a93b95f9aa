#pragma once
/// When timings can tell which of two builds is faster.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/gate/bootstrap.hpp"

namespace superstep {

/// What timings must be like before anything is concluded from them.
struct TimingLimits {
  std::size_t rounds = 6;   ///< timings of fewer rounds tell nothing
  double shortest = 0.005;  ///< s, nor do shorter ones
  /// Clearly slower: the whole interval lies above this; clearly faster: below its reciprocal.
  double slower = 1.05;
};

/// What the gate, `compare` and the report's changes go by.
inline constexpr TimingLimits timing_limits;

/// Why two sets of timings tell nothing.
struct TimingDoubt {
  enum class Kind { too_few_rounds, too_short, at_odds } kind = Kind::too_few_rounds;
  double shortest = 0;                ///< s, where they are too short
  const PairedTimings* of = nullptr;  ///< the set that disagrees with itself
  RatioInterval itself;               ///< by how much
};

/// The CPU times of two builds in one unit.
struct ComparableTimes {
  PairedTimings before, now;
  bool in_yardsticks = false;  ///< each in units of the yardstick of its own rounds, else in seconds
};
/// In yardsticks where both have one a round.
///   cpu, yardstick [rounds] s
[[nodiscard]] ComparableTimes in_one_unit(const std::vector<double>& cpu_before,
                                          const std::vector<double>& yardstick_before,
                                          const std::vector<double>& cpu_now,
                                          const std::vector<double>& yardstick_now);

/// Looks at the rounds of both, then at their length, then compares each with itself; empty = they can tell.
/// Refers to what it was given.
[[nodiscard]] std::optional<TimingDoubt> doubt_about(const PairedTimings& before, const PairedTimings& now,
                                                     const TimingLimits& limits);

/// What makes timings able to tell, as a sentence.
[[nodiscard]] std::string timing_rule(const TimingLimits& limits);

}  // namespace superstep
