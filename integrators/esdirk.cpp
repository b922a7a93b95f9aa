/// Diagonally implicit Runge-Kutta method of order four with an explicit first stage, L-stable and stiffly
/// accurate; error from an embedded result of order three.
/// Source: Kennedy & Carpenter (2003), doi:10.1016/S0168-9274(02)00138-1, ARK4(3)6L[2]SA, implicit part.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/parallel.hpp"
#include "integrators/detail/implicit/implicit_stage.hpp"
#include "integrators/detail/tolerance.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

constexpr std::size_t stages = 6;
constexpr double gamma = 0.25;
constexpr std::array<double, stages> c = {0, 0.5, 83.0 / 250, 31.0 / 50, 17.0 / 20, 1};
constexpr std::array<std::array<double, stages - 1>, stages> a = {{
    {},
    {gamma},
    {8611.0 / 62500, -1743.0 / 31250},
    {5012029.0 / 34652500, -654441.0 / 2922500, 174375.0 / 388108},
    {15267082809.0 / 155376265600, -71443401.0 / 120774400, 730878875.0 / 902184768, 2285395.0 / 8070912},
    {82889.0 / 524892, 0, 15625.0 / 83664, 69875.0 / 102672, -2260.0 / 8211},
}};
constexpr std::array<double, stages> b = {82889.0 / 524892, 0,    15625.0 / 83664, 69875.0 / 102672,
                                          -2260.0 / 8211,   gamma};
constexpr std::array<double, stages> embedded = {4586570599.0 / 29645900160, 0,
                                                 178811875.0 / 945068544,    814220225.0 / 1159782912,
                                                 -3700637.0 / 11593932,      61727.0 / 225920};

class Esdirk final : public OneStepMethod {
 public:
  explicit Esdirk(const Options& options)
      : rtol_(options.number("rtol")), fixed_step_(fixed_step_of(options)), solver_(options.word("solver")) {}

  void prepare(Rhs& rhs, const Task& task) override {
    rhs_ = &rhs;
    norm_.prepare(rhs, task.allowed);
    const std::string solver = solver_ == "auto" ? fastest_linear_solver(rhs) : solver_;
    if (solver_ == "auto") choice_ = "solver=" + solver;
    stage_.prepare(rhs, task, solver);
    for (auto& f : slope_) f.resize(rhs.size());
    for (auto* v : {&base_, &error_}) v->resize(rhs.size());
  }
  [[nodiscard]] double rtol() const override { return fixed_step_ > 0 ? 0 : rtol_; }
  [[nodiscard]] Pace pace() const override { return fixed_step_ > 0 ? Pace::equal : Pace::error; }
  [[nodiscard]] double own_step(double t, std::span<const double> y) override {
    return fixed_step_ > 0 ? fixed_step_ : 1 / rhs_->spectral_bound(t, y);
  }
  [[nodiscard]] double worth_changing() const override { return 1.2; }
  [[nodiscard]] int order() const override { return 3; }
  [[nodiscard]] double share() const override {
    constexpr double tight = 1e-5, least = 0.22;
    // Of a bend inside a step the two results know as little as each other.
    const double seen = rhs_->traits().smooth ? 1 : 0.1;
    return seen * std::clamp(least * std::pow(rtol_ / tight, 0.3), least, 1.0);
  }
  [[nodiscard]] std::span<const double> slope() const override { return slope_[0]; }
  void restart(double t, std::span<const double> y, bool /*smooth*/) override { (*rhs_)(t, y, slope_[0]); }

  Trial attempt(const Step& step, StateVector& state, StateVector& next) override {
    const double h = step.h(), precision = fixed_step_ > 0 ? 0 : 1e-3 * share();
    if (!stage_.set(gamma * h, step.t, state)) return {.solved = false, .reason = "the matrix is singular"};
    for (std::size_t i = 1; i < stages; ++i) {
      for_each_entry(state.size(), [&](std::size_t n) {
        double sum = 0;
        for (std::size_t j = 0; j < i; ++j) sum += a[i][j] * slope_[j][n];
        base_[n] = state[n] + h * sum;
        next[n] = base_[n] + gamma * h * slope_[i - 1][n];
      });
      const auto result = stage_.solve(step.t + c[i] * h, base_, precision, next, slope_[i]);
      if (!result.solved) return {.solved = false, .reason = result.reason};
    }
    if (fixed_step_ > 0) return {};
    for_each_entry(state.size(), [&](std::size_t n) {
      double sum = 0;
      for (std::size_t j = 0; j < stages; ++j) sum += (b[j] - embedded[j]) * slope_[j][n];
      error_[n] = h * sum;
    });
    return {.error = norm_.of([&](std::size_t n) { return error_[n]; })};
  }
  /// The last stage is the result: its slope is the next step's first.
  void accept(const Step& /*step*/, std::span<const double> /*state*/) override {
    std::swap(slope_.front(), slope_.back());
  }
  void reset_counts() override { stage_.reset_counts(); }
  void add_counts(Statistics& statistics) const override {
    statistics.max_stages = static_cast<int>(stages) - 1;
    stage_.add_counts(statistics);
  }
  [[nodiscard]] std::string choice() const override { return choice_; }

 private:
  double rtol_, fixed_step_;
  std::string solver_, choice_;
  Rhs* rhs_ = nullptr;
  ErrorNorm norm_;
  ImplicitStage stage_;
  std::array<StateVector, stages> slope_;
  StateVector base_, error_;
};

}  // namespace

IntegratorEntry esdirk_entry() {
  return {
      .name = "esdirk",
      .summary =
          "L-stable diagonally implicit Runge-Kutta method of order four, also for stiff nonlinear scenes",
      .source = "Kennedy & Carpenter (2003), doi:10.1016/S0168-9274(02)00138-1",
      .colour = "#5b8c5a",
      .order = 4,
      .adaptive = true,
      .distributed = Distributed::exact,
      .gathered_where = "but for solver=pcg on linear scenes",
      .keys = {tolerance_key("1e-4"),
               {.name = "solver",
                .type = OptionKey::Type::word,
                .words = {"auto", "klu", "cholmod", "pcg"},
                .fallback = "auto",
                .meaning = "how a stage is solved; auto takes the fastest"},
               fixed_step_key()},
      .examples = {"esdirk:rtol=1e-6", "esdirk:step=15"},
      .ladder = rtol_ladder("esdirk", 2, 9),
      .make = [](const Options& options) { return std::make_unique<Esdirk>(options); }};
}

}  // namespace superstep
