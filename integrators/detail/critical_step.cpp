#include "integrators/detail/critical_step.hpp"

#include <array>

namespace superstep {
namespace {

constexpr double default_fraction = 0.9;

}  // namespace

std::vector<OptionKey> critical_step_keys() {
  return {
      {.name = "step",
       .min = 0,
       .min_open = true,
       .unit = "s",
       .fallback = "",
       .meaning = "critical step, as given"},
      {.name = "alpha",
       .min = 0,
       .min_open = true,
       .fallback = "",
       .meaning =
           "critical step = alpha x smallest pairwise step without interface (not a bound; may be unstable)"},
      {.name = "fraction",
       .min = 0,
       .min_open = true,
       .fallback = "0.9",
       .meaning = "critical step = fraction x certified limit 2/min(edge bound, Gershgorin)"},
  };
}

CriticalStep::CriticalStep(const Options& options) {
  static const std::array<std::string, 3> keys = {"step", "alpha", "fraction"};
  options.at_most_one_of(keys);
  if (const auto step = options.number("step")) {
    rule_ = Rule::step;
    value_ = *step;
  } else if (const auto alpha = options.number("alpha")) {
    rule_ = Rule::alpha;
    value_ = *alpha;
  } else {
    rule_ = Rule::fraction;
    value_ = options.number("fraction").value_or(default_fraction);
  }
}

bool CriticalStep::may_have_changed(Rhs& rhs, double t, std::span<const double> y) const {
  const bool settled = rhs.settle(t, y, 0);
  return rule_ == Rule::fraction && (settled || !rhs.traits().constant_jacobian);
}

double CriticalStep::resolve(Rhs& rhs, double t, std::span<const double> y) const {
  switch (rule_) {
    case Rule::step:
      return value_;
    case Rule::alpha:
      return value_ * rhs.pair_step_without_interface();
    case Rule::fraction:
      break;
  }
  const double bound = rhs.spectral_bound(t, y);
  return bound > 0 ? value_ * 2 / bound : std::numeric_limits<double>::infinity();
}

}  // namespace superstep
