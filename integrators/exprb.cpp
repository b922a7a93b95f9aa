/// Exponential Rosenbrock method of order four: with J = df/dy and v = df/dt at the step's start, the
/// linear part is integrated exactly and what is left, D(s) = f(t+s, U) - f(t, u) - J (U - u) - s v, twice
/// looked at. Error from the embedded result of order three.
/// Source: Hochbruck, Ostermann & Schweitzer (2009), doi:10.1137/080717717, exprb43.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.hpp"
#include "integrators/detail/krylov/krylov_space.hpp"
#include "integrators/detail/tolerance.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

constexpr std::size_t basis_bytes = 128'000'000;  // that a space may take, unless its network is larger
constexpr std::size_t fewest_of_a_step = 40, most_of_a_step = 400;

class ExponentialRosenbrock final : public OneStepMethod {
 public:
  explicit ExponentialRosenbrock(const Options& options)
      : rtol_(options.number("rtol")), fixed_step_(fixed_step_of(options)) {}

  void prepare(Rhs& rhs, const Task& task) override {
    rhs_ = &rhs;
    norm_.prepare(rhs, task.allowed);
    rounding_ = task.rounding;
    run_length_ = task.t_end - task.t_begin;
    cut_short_ = false;
    jacobian_.prepare(rhs, task);
    const std::size_t n = std::max<std::size_t>(1, rhs.size());
    const std::size_t most = std::clamp(basis_bytes / (sizeof(double) * n), fewest_of_a_step, most_of_a_step);
    const std::size_t depth = rhs.fields().size() > 1 ? depth_of_coupled : 2;
    for (auto* space : {&of_slope_, &of_drift_, &of_first_, &of_second_})
      space->prepare(rhs, norm_, jacobian_, most, depth);
    for (auto* v : {&slope_, &drift_, &difference_, &linear_, &first_, &second_, &stage_}) v->resize(n);
  }
  [[nodiscard]] double rtol() const override { return fixed_step_ > 0 ? 0 : rtol_; }
  [[nodiscard]] Pace pace() const override { return fixed_step_ > 0 ? Pace::equal : Pace::error; }
  [[nodiscard]] double own_step(double t, std::span<const double> y) override {
    return fixed_step_ > 0 ? fixed_step_ : 1 / rhs_->spectral_bound(t, y);
  }
  [[nodiscard]] int order() const override { return 3; }
  /// Fitted to random scenes of every class: what is delivered is then as many times rtol at 1e-3 as at 1e-7.
  [[nodiscard]] double share() const override { return 0.3 * std::pow(rtol_ / 1e-5, 0.1); }
  [[nodiscard]] std::span<const double> slope() const override { return slope_; }
  /// Knots make many short steps, and so do spaces that reach no further: what they are wrong by adds up.
  [[nodiscard]] double part_of_run(double h) const {
    if (rhs_->traits().autonomous && !cut_short_) return 1.0;
    return std::clamp(10 * h / run_length_, cut_short_ ? 1e-3 : 0.03, 1.0);
  }
  void restart(double t, std::span<const double> y, bool /*smooth*/) override { begin_at(t, y); }
  void accept(const Step& step, std::span<const double> state) override { begin_at(step.ends.back(), state); }

  Trial attempt(const Step& step, StateVector& state, StateVector& next) override;

  void reset_counts() override { most_products_ = 0; }
  void add_counts(Statistics& statistics) const override {
    statistics.max_stages = static_cast<int>(most_products_);
  }

 private:
  static constexpr std::size_t depth_of_coupled = 8;
  using Term = KrylovSpace::Term;

  void begin_at(double t, std::span<const double> y) {
    (*rhs_)(t, y, slope_);
    linearised_ = false;
  }
  void linearise(const Step& step, const StateVector& y);
  /// D at the stage in stage_.
  void difference_at(double t, double s, const StateVector& y, StateVector& out);
  /// What the spaces of a step of h may be wrong by, in units of the tolerance.
  [[nodiscard]] double precision(double h) const {
    // What is left of a residual decays within the step: a space errs by a few hundredths of its bound.
    constexpr double of_change = 1e-12;
    return fixed_step_ > 0 ? of_change * h * of_slope_.length()
                           : std::max(share() * part_of_run(h), rounding_);
  }
  ///   allowed  for the space's own term, of a step
  template <class Allowed>
  [[nodiscard]] Trial too_many(KrylovSpace& space, double h, int k, const Allowed& allowed);

  double rtol_, fixed_step_;
  Rhs* rhs_ = nullptr;
  ErrorNorm norm_;
  double rounding_ = 0, run_length_ = 0;  ///< part of the tolerance; s
  ScaledJacobian jacobian_;
  KrylovSpace of_slope_, of_drift_, of_first_, of_second_;
  bool linearised_ = false;
  bool cut_short_ = false;     ///< a step, by what a space may hold
  StateVector slope_, drift_;  ///< f and v at the step's start
  StateVector difference_, linear_, stage_;
  StateVector first_, second_;  ///< D at the middle and at the end
  std::size_t most_products_ = 0;
};

/// J, v and the spaces of f and v belong to the step's start: trials of other lengths use them, too.
void ExponentialRosenbrock::linearise(const Step& step, const StateVector& y) {
  if (linearised_) return;
  linearised_ = true;
  jacobian_.set(step.t, y);
  of_slope_.begin([&](std::size_t i) { return slope_[i]; });
  if (rhs_->traits().autonomous) return;
  // Inputs are lines in time here, also beyond the piece: a central difference of a few roundings is
  // exact but for what is quadratic in an input.
  constexpr double small = 1e-3;
  const double delta = small * step.h();
  (*rhs_)(step.t - delta, y, difference_);
  (*rhs_)(step.t + delta, y, drift_);
  for_each_entry(drift_.size(),
                 [&](std::size_t i) { drift_[i] = (drift_[i] - difference_[i]) / (2 * delta); });
  of_drift_.begin([&](std::size_t i) { return drift_[i]; });
}

void ExponentialRosenbrock::difference_at(double t, double s, const StateVector& y, StateVector& out) {
  const auto scale = jacobian_.scale(), inverse = jacobian_.inverse();
  for_each_entry(y.size(), [&](std::size_t i) { difference_[i] = scale[i] * (stage_[i] - y[i]); });
  (void)jacobian_.multiply(difference_.data(), difference_.data(), linear_.data());
  (*rhs_)(t + s, stage_, out);
  const double drifted = rhs_->traits().autonomous ? 0 : s;
  for_each_entry(y.size(),
                 [&](std::size_t i) { out[i] -= slope_[i] + inverse[i] * linear_[i] + drifted * drift_[i]; });
}

template <class Allowed>
Trial ExponentialRosenbrock::too_many(KrylovSpace& space, double h, int k, const Allowed& allowed) {
  cut_short_ = true;
  return {.solved = false,
          .factor = fixed_step_ > 0 ? 0 : space.longest(h, k, allowed) / h,
          .reason = fmt::format("a Krylov space does not reach the tolerance with a step of {:.3g} s; take a "
                                "smaller one",
                                h)};
}

Trial ExponentialRosenbrock::attempt(const Step& step, StateVector& state, StateVector& next) {
  const double h = step.h(), half = h / 2, t = step.t;
  const bool driven = !rhs_->traits().autonomous, linear = rhs_->traits().linear;
  linearise(step, state);
  for (auto* space : {&of_slope_, &of_drift_, &of_first_, &of_second_}) space->reset_products();
  const auto of_slope = [this](double s) { return precision(s); };
  const auto of_drift = [this](double s) { return precision(s) / s; };
  const auto of_first = [this](double s) { return precision(s) / 8; };
  const auto of_second = [this](double s) { return precision(s) / 12; };

  // next = u + h phi_1(hJ) f + h^2 phi_2(hJ) v, and the same at the middle in stage_.
  if (!of_slope_.reach(h, 1, of_slope(h))) return too_many(of_slope_, h, 1, of_slope);
  if (driven && !of_drift_.reach(h, 2, of_drift(h))) return too_many(of_drift_, h, 2, of_drift);
  const std::array whole_f = {Term{h, 1, 1}}, half_f = {Term{half, 1, 1}};
  of_slope_.combine(whole_f, half_f, [&](std::size_t i, double at_end, double at_half) {
    next[i] = state[i] + at_end;
    stage_[i] = state[i] + at_half;
  });
  if (driven) {
    const std::array whole_v = {Term{h, 2, h}}, half_v = {Term{half, 2, half}};
    of_drift_.combine(whole_v, half_v, [&](std::size_t i, double at_end, double at_half) {
      next[i] += at_end;
      stage_[i] += at_half;
    });
  }
  double error = 0;
  if (!linear) {
    difference_at(t, half, state, first_);
    of_first_.begin([&](std::size_t i) { return first_[i]; });
    if (!of_first_.reach(h, 3, of_first(h))) return too_many(of_first_, h, 3, of_first);
    const std::array stage_part = {Term{h, 1, 1}}, result_part = {Term{h, 3, 8}};
    of_first_.combine(stage_part, result_part, [&](std::size_t i, double at_stage, double in_result) {
      stage_[i] = next[i] + at_stage;
      next[i] += in_result;
    });
    difference_at(t, h, state, second_);
    // 16 phi_3 D_2 - 2 phi_3 D_3 + 12 phi_4 (D_3 - 4 D_2) in terms of E = D_3 - 4 D_2, which is smaller.
    of_second_.begin([&](std::size_t i) { return second_[i] - 4 * first_[i]; });
    if (!of_second_.reach(h, 4, of_second(h))) return too_many(of_second_, h, 4, of_second);
    const std::array correction = {Term{h, 3, -2}, Term{h, 4, 12}};
    const std::array estimate = {Term{h, 4, 12}};
    of_second_.combine(correction, estimate, [&](std::size_t i, double in_result, double estimated) {
      next[i] += in_result;
      difference_[i] = estimated;
    });
    // The estimate is that of the embedded result of order three, which is given up for the one of order
    // four. Where inputs move or laws bend that one need not be better.
    const double given_up = rhs_->traits().smooth && !driven ? 0.05 : 1;
    error = given_up * norm_.of([&](std::size_t i) { return difference_[i]; });
  }
  std::size_t products = linear ? 0 : 2;
  for (const auto* space : {&of_slope_, &of_drift_, &of_first_, &of_second_}) products += space->products();
  most_products_ = std::max(most_products_, products);
  return {.error = fixed_step_ > 0 ? 0 : error};
}

}  // namespace

IntegratorEntry exprb_entry() {
  return {.name = "exprb",
          .summary = "exponential Rosenbrock method of order four, for nonlinear and driven scenes",
          .source = "Hochbruck, Ostermann & Schweitzer (2009), doi:10.1137/080717717",
          .colour = "#7f6bb3",
          .order = 4,
          .adaptive = true,
          .keys = {tolerance_key("1e-4"), fixed_step_key()},
          .examples = {"exprb:rtol=1e-6", "exprb:step=15"},
          .ladder = rtol_ladder("exprb", 2, 10),
          .make = [](const Options& options) { return std::make_unique<ExponentialRosenbrock>(options); }};
}

}  // namespace superstep
