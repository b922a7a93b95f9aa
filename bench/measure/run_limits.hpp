#pragma once
/// What a run may cost, and who is told when it will cost much.

#include <cstdint>
#include <functional>
#include <string>

namespace superstep {

struct RunLimits {
  double seconds = 0;        ///< wall time of one run, preparation included; 0 = no limit
  bool of_cpu = false;       ///< the seconds are CPU time
  std::uint64_t sweeps = 0;  ///< passes over the network; 0 = no limit
  /// Told, once and from another thread, what a run that will last will need; empty = nobody is.
  std::function<void(const std::string& forecast)> say = {};
};

/// A time in words: "90 s", "3 minutes", "4 hours".
[[nodiscard]] std::string duration_text(double seconds);

/// What to say of a run after its first seconds; empty when it will soon be over.
///   spec      the method
///   part      of the simulated time that is done, 0 to 1
///   seconds   that this took
///   allowed   seconds that the run may take; 0 = any
///   faster    SPEC of a method that would be faster; empty = unknown
[[nodiscard]] std::string forecast_text(const std::string& spec, double part, double seconds, double allowed,
                                        const std::string& faster);

}  // namespace superstep
