#include "dynamics/stepping.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace superstep::dynamics {
namespace {

void require(bool condition, const char* key, double value, const char* rule) {
  if (!condition) throw InputError(fmt::format("stepping: {} is {}; {}", key, value, rule));
}

}  // namespace

void check_settings(const SteppingSettings& settings) {
  require(settings.phi >= 0 && settings.phi <= 1, "phi", settings.phi, "it must lie between 0 and 1");
  require(settings.iterations >= 2, "iterations", settings.iterations, "it must be at least 2");
  require(settings.tolerance_position > 0, "tolerance of positions", settings.tolerance_position,
          "it must be > 0");
  require(settings.tolerance_temperature > 0, "tolerance of temperatures", settings.tolerance_temperature,
          "it must be > 0");
  require(settings.power > 0, "power", settings.power, "it must be > 0");
  require(settings.smallest_step > 0, "smallest_step", settings.smallest_step, "it must be > 0 s");
  require(settings.largest_step >= settings.smallest_step, "largest_step", settings.largest_step,
          "it must not be below smallest_step");
  require(settings.first_step >= settings.smallest_step, "first_step", settings.first_step,
          "it must not be below smallest_step");
  require(settings.bounds.growth > 1, "growth", settings.bounds.growth, "it must be > 1");
  require(settings.bounds.shrink > 0 && settings.bounds.shrink < settings.bounds.rejected_shrink, "shrink",
          settings.bounds.shrink, "it must lie between 0 and 0.9");
  require(settings.fraction > 0 && settings.fraction <= 2, "fraction", settings.fraction,
          "it must lie between 0 and 2");
}

}  // namespace superstep::dynamics
