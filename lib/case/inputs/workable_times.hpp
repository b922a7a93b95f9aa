#pragma once
/// Times that can be computed with.

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "core/text/toml.hpp"

namespace superstep {

inline constexpr double shortest_time = 1 / largest_number, longest_time = largest_number;  // s

/// Why no method can compute with a time, or with the time between two instants; empty where one can. Squares
/// of such numbers leave the range of a double.
///   what  "the output time"
[[nodiscard]] inline std::string unworkable_time(std::string_view what, double t) {
  if (t >= shortest_time && t <= longest_time) return {};
  return fmt::format("{} {} s is beyond what can be computed with; it must lie between {:g} and {:g} s", what,
                     t, shortest_time, longest_time);
}

/// The same of instants, which may be 0 and before it, and of the times between neighbours, which may be 0.
/// Calls reject(index, rule) for the first one that is beyond.
template <class Reject>
void require_workable_instants(std::span<const double> time, Reject reject) {
  for (std::size_t k = 0; k < time.size(); ++k) {
    const double apart = k > 0 ? std::abs(time[k] - time[k - 1]) : 0;
    std::string rule = time[k] != 0 ? unworkable_time("the instant", std::abs(time[k])) : "";
    if (rule.empty() && apart != 0)
      rule = unworkable_time(fmt::format("between the instants {} and {} s, the time", time[k - 1], time[k]),
                             apart);
    if (!rule.empty()) reject(k, rule);
  }
}

}  // namespace superstep
