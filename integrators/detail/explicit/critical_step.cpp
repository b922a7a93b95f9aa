#include "integrators/detail/explicit/critical_step.hpp"

#include <array>
#include <limits>

namespace superstep {

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
       .meaning = "critical step = fraction x limit 2/radius"},
      {.name = "bound",
       .type = OptionKey::Type::word,
       .words = {"certified", "lanczos"},
       .fallback = "certified",
       .meaning =
           "radius of that limit: certified by min(edge bound, Gershgorin), or the sharp one that Lanczos "
           "finds and a reserve of 1 to 2 % (where conductances are constant)"},
  };
}

CriticalStep::CriticalStep(const Options& options) : radius_(options.word("bound") == "lanczos") {
  static const std::array<std::string, 3> keys = {"step", "alpha", "fraction"};
  options.at_most_one_of(keys);
  if (const auto step = options.given("step")) {
    rule_ = Rule::step;
    value_ = *step;
  } else if (const auto alpha = options.given("alpha")) {
    rule_ = Rule::alpha;
    value_ = *alpha;
  } else {
    rule_ = Rule::fraction;
    value_ = options.number("fraction");
  }
}

void CriticalStep::prepare(Rhs& rhs, std::span<const double> spans) {
  rhs_ = &rhs;
  radius_.prepare(rhs, spans);
}

bool CriticalStep::varies() const noexcept {
  return rule_ == Rule::fraction && radius_.varies();
}

double CriticalStep::at(double t, std::span<const double> y) {
  switch (rule_) {
    case Rule::step:
      return value_;
    case Rule::alpha:
      return value_ * rhs_->facts().pair_step;
    case Rule::fraction:
      break;
  }
  return value_ * limit(t, y);
}

double CriticalStep::limit(double t, std::span<const double> y) {
  constexpr double none = std::numeric_limits<double>::infinity();
  if (rule_ != Rule::fraction) return none;
  const double radius = radius_.at(t, y);
  return radius > 0 ? 2 / radius : none;
}

}  // namespace superstep
