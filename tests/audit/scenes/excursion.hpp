#pragma once
/// Something that changes in time, as a shape between 0 and 1: ramps, pulses, a heater that goes on and off,
/// steps, sampled profiles.

#include "core/random.hpp"
#include "core/time_table.hpp"

namespace superstep::audit {

struct Excursion {
  TimeTable shape;     ///< values between 0 and 1
  double active = 0;   ///< s, integral of the shape over the run
  double inside = -1;  ///< s, a time within a pulse; -1 = there is no pulse
  /// base + (peak - base) * shape.
  [[nodiscard]] TimeTable between(double base, double peak) const;
};

///   steps        equal neighbouring times are allowed
///   most_points  of a sampled profile, >= 5
[[nodiscard]] Excursion random_excursion(Random& random, double t_end, bool steps, std::size_t most_points);

/// exp of a number that is uniform between log(low) and log(high).
[[nodiscard]] double log_uniform(Random& random, double low, double high);

}  // namespace superstep::audit
