#include "reports/gate/timing_rule.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/median.hpp"

namespace superstep {

ComparableTimes in_one_unit(const std::vector<double>& cpu_before,
                            const std::vector<double>& yardstick_before, const std::vector<double>& cpu_now,
                            const std::vector<double>& yardstick_now) {
  const bool in_yardsticks =
      yardstick_before.size() == cpu_before.size() && yardstick_now.size() == cpu_now.size();
  const auto timings = [&](const std::vector<double>& cpu, const std::vector<double>& yardstick) {
    return PairedTimings{cpu, in_yardsticks ? yardstick : std::vector<double>(cpu.size(), 1.0)};
  };
  return {timings(cpu_before, yardstick_before), timings(cpu_now, yardstick_now), in_yardsticks};
}

std::optional<TimingDoubt> doubt_about(const PairedTimings& before, const PairedTimings& now,
                                       const TimingLimits& limits) {
  using enum TimingDoubt::Kind;
  if (std::min(before.rounds(), now.rounds()) < std::max<std::size_t>(limits.rounds, 2))
    return TimingDoubt{.kind = too_few_rounds, .itself = {}};
  double shortest = median_of(before.work);
  for (const auto* times : {&before.yardstick, &now.work, &now.yardstick})
    shortest = std::min(shortest, median_of(*times));
  if (shortest < limits.shortest) return TimingDoubt{.kind = too_short, .shortest = shortest, .itself = {}};
  for (const auto* timings : {&before, &now})
    if (const auto itself = against_itself(*timings);
        itself.above(limits.slower) || itself.below(1 / limits.slower))
      return TimingDoubt{.kind = at_odds, .of = timings, .itself = itself};
  return std::nullopt;
}

std::string timing_rule(const TimingLimits& limits) {
  return fmt::format(
      "Times can tell from {} rounds and {:g} ms on: give bench --repetitions {} or more, and longer runs.",
      limits.rounds, 1e3 * limits.shortest, limits.rounds);
}

}  // namespace superstep
