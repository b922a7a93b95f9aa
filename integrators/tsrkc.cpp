/// Two-step Runge-Kutta-Chebyshev of second order; the first step, and each one after a break, is one of
/// RKC2. Source: see schemes/two_step_chebyshev.hpp.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/parallel.hpp"
#include "integrators/detail/error_norm.hpp"
#include "integrators/detail/explicit/spectral_radius.hpp"
#include "integrators/detail/tolerance.hpp"
#include "integrators/registry.hpp"
#include "integrators/schemes/stabilised_schemes.hpp"
#include "integrators/schemes/two_step_chebyshev.hpp"

namespace superstep {
namespace {

class TwoStepMethod final : public OneStepMethod {
 public:
  explicit TwoStepMethod(const Options& options)
      : rtol_(options.number("rtol")), fixed_step_(fixed_step_of(options)) {}

  void prepare(Rhs& rhs, const Task& task) override {
    rhs_ = &rhs;
    norm_.prepare(rhs, task.allowed);
    radius_.prepare(rhs, task.spans);
    step_before_ = 0;
    engine_.resize(rhs.size());
    for (auto* v : {&derivative_, &next_derivative_, &before_, &here_}) v->resize(rhs.size());
    most_ = start_.stages_within_rounding(
        task.rounding > 0 ? std::numeric_limits<double>::epsilon() / task.rounding : rtol_);
    for (auto* v : {&scheme_.m, &scheme_.n, &scheme_.mt, &scheme_.gt, &scheme_.c})
      v->reserve(static_cast<std::size_t>(start_.most_stages) + 1);
  }
  [[nodiscard]] double rtol() const override { return fixed_step_ > 0 ? 0 : rtol_; }
  [[nodiscard]] Pace pace() const override { return fixed_step_ > 0 ? Pace::multiples : Pace::error; }
  [[nodiscard]] double own_step(double t, std::span<const double> y) override {
    return fixed_step_ > 0 ? fixed_step_ : 1 / radius_.at(t, y);
  }
  [[nodiscard]] bool stability_varies() const override { return fixed_step_ == 0 && radius_.varies(); }
  [[nodiscard]] double longest_step(double t, std::span<const double> y) override {
    radius_now_ = radius_.at(t, y);
    return start_.beta(most_) / radius_now_;  // the interval is never shorter than that of the start
  }
  [[nodiscard]] double stable_step(double t, std::span<const double> y) override {
    return scheme_.beta / radius_.at(t, y);
  }
  /// A slightly longer step costs nothing where the stages are enough for it; the one before is then shorter
  /// beside it.
  [[nodiscard]] double convenient(double h, double longest) const override {
    constexpr double longest_stretch = 1.1;
    if (!(radius_now_ > 0)) return h;
    const double z = std::min(h, longest) * radius_now_, ratio = ratio_before(longest_stretch * h);
    const double beta = ratio == 0 ? start_.beta(start_.stages_for(z))
                                   : two_step_chebyshev(two_step_stages(z, ratio), ratio).beta;
    return std::min(longest_stretch * h, beta / radius_now_);
  }
  [[nodiscard]] int order() const override { return 2; }
  /// Grows with rtol as that of the one-step methods of order two; twice as large, by the audit
  /// (tests/audit).
  [[nodiscard]] double share() const override { return std::min(0.7, 60 * std::sqrt(rtol_)); }
  [[nodiscard]] std::span<const double> slope() const override { return derivative_; }

  void restart(double t, std::span<const double> y, bool smooth) override {
    if (!smooth) step_before_ = 0;
    (*rhs_)(t, y, derivative_);
  }

  [[nodiscard]] Trial attempt(const Step& step, StateVector& state, StateVector& next) override {
    const double h = step.h(), ratio = ratio_before(h);
    if (fixed_step_ > 0) radius_now_ = radius_.at(step.t, state);
    const bool starts = ratio == 0;
    const double z = h * radius_now_;
    const int stages = starts ? start_.stages_for(z) : two_step_stages(z, ratio);
    if (stages > start_.most_stages)
      return {
          .solved = false,
          .reason = fmt::format("more than {} stages are needed; take a smaller step", start_.most_stages)};
    most_stages_ = std::max(most_stages_, stages);
    const TwoStepChebyshev now = starts ? TwoStepChebyshev{} : two_step_chebyshev(stages, ratio);
    if (starts)
      start_.build(stages, scheme_);
    else
      two_step_recurrence(stages, now, scheme_);
    engine_.step(*rhs_, scheme_, step.t, h, state, derivative_);
    std::swap(next, engine_.result());
    for_each_entry(next.size(), [&](std::size_t i) {
      here_[i] = state[i];
      next[i] += now.before * (before_[i] - next[i]);
    });
    (*rhs_)(step.ends.front(), next, next_derivative_);
    if (fixed_step_ > 0) return {};
    const double error =
        starts ? 1.0 / 6 - taylor_coefficient(scheme_, 3) : two_step_error(now, scheme_, ratio);
    return {.error = norm_.of([&](std::size_t i) {
      return 12 * error * (state[i] - next[i] + h / 2 * (derivative_[i] + next_derivative_[i]));
    })};
  }

  void accept(const Step& step, std::span<const double> /*state*/) override {
    std::swap(before_, here_);
    std::swap(derivative_, next_derivative_);
    step_before_ = step.h();
  }
  void reset_counts() override { most_stages_ = 0; }
  void add_counts(Statistics& statistics) const override {
    statistics.max_stages = std::max(statistics.max_stages, most_stages_);
  }

 private:
  /// The step before over one of h; 0 where there is none, or where it is so long beside h that a third
  /// derivative would be judged by what lies far back: such a step begins anew.
  [[nodiscard]] double ratio_before(double h) const noexcept {
    constexpr double longest = 3;
    return step_before_ <= longest * h ? step_before_ / h : 0;
  }

  const StabilisedFamily& start_ = rkc2_family();
  double rtol_, fixed_step_;
  Rhs* rhs_ = nullptr;
  ErrorNorm norm_;
  SpectralRadius radius_;
  ThreeTermScheme scheme_;
  ThreeTermEngine engine_;
  int most_ = 0, most_stages_ = 0;
  double radius_now_ = 0;      ///< at the step's start [1/s]
  double step_before_ = 0;     ///< s; 0 = nothing is known of what was before
  StateVector before_, here_;  ///< at its start; at the start of the last trial
  StateVector derivative_, next_derivative_;
};

}  // namespace

IntegratorEntry tsrkc_entry() {
  return {.name = "tsrkc",
          .summary = "two-step Runge-Kutta-Chebyshev, a longer interval of stability than RKC's",
          .source = "Moisa (2024), J. Comput. Appl. Math., PII S0377-0427(24)00117-1",
          .colour = "#7f9c2c",
          .order = 2,
          .adaptive = true,
          .distributed = Distributed::exact,
          .keys = {tolerance_key("1e-4"), fixed_step_key()},
          .examples = {"tsrkc:rtol=1e-6", "tsrkc:step=0.1"},
          .ladder = rtol_ladder("tsrkc", 1, 8),
          .make = [](const Options& options) { return std::make_unique<TwoStepMethod>(options); }};
}

}  // namespace superstep
