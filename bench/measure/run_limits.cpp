#include "bench/measure/run_limits.hpp"

#include <fmt/format.h>

namespace superstep {
namespace {

constexpr double minute = 60, hour = 3600, day = 24 * hour, year = 365 * day;  // s

/// A limit as it was given.
std::string limit_text(double seconds) {
  return seconds < 2 * minute ? fmt::format("{:g} s", seconds) : duration_text(seconds);
}

}  // namespace

std::string duration_text(double seconds) {
  if (seconds < 2 * minute) return fmt::format("{:.0f} s", seconds);
  if (seconds < 2 * hour) return fmt::format("{:.0f} minutes", seconds / minute);
  if (seconds < 2 * day) return fmt::format("{:.0f} hours", seconds / hour);
  if (seconds < 2 * year) return fmt::format("{:.0f} days", seconds / day);
  return fmt::format("{:.2g} years", seconds / year);
}

std::string forecast_text(const std::string& spec, double part, double seconds, double allowed,
                          const std::string& faster) {
  const double whole = part > 0 ? seconds / part : 0;
  if (part > 0 && whole < minute) return {};
  std::string text =
      part > 0 ? fmt::format("{}: {:.2g} % of the time are done after {}; at this rate all of it takes {}",
                             spec, 100 * part, duration_text(seconds), duration_text(whole))
               : fmt::format("{}: no step is done after {}", spec, duration_text(seconds));
  if (allowed > 0 && seconds > allowed)
    text += fmt::format(
        "; its time was up after {} (--time-limit), and it ends with the step or the factorization "
        "that it is in",
        limit_text(allowed));
  else if (allowed > 0 && (part == 0 || whole > allowed))
    text += fmt::format("; it ends after {} (--time-limit)", limit_text(allowed));
  if ((part == 0 || whole > hour) && !faster.empty()) text += fmt::format("; {} would be faster", faster);
  return text;
}

}  // namespace superstep
