/// Heun's method, the example of integrators/README.md: order two, stable like forward Euler.
/// Source: Heun (1900), Z. Math. Phys. 45, 23-38.

#include <fmt/format.h>

#include "integrators/detail/explicit/critical_step.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

class Heun final : public OneStepMethod {
 public:
  explicit Heun(const Options& options) : critical_step_(options) {}

  void prepare(Rhs& rhs, const Task& task) override {
    rhs_ = &rhs;
    critical_step_.prepare(rhs, task.spans);
    trial_.resize(rhs.size());
  }
  Pace pace() const override { return Pace::multiples; }
  double own_step(double t, std::span<const double> y) override { return critical_step_.at(t, y); }
  bool stability_varies() const override { return critical_step_.varies(); }
  double stable_step(double t, std::span<const double> y) override { return critical_step_.limit(t, y); }
  void restart(double, std::span<const double>, bool) override {}

  Trial attempt(const Step& step, StateVector& y, StateVector& next) override {
    const double h = step.h();  // first y + h f(t, y), then the mean of y and an Euler step from there
    rhs_->stage(step.t, {.y1 = y.data(), .a = 1, .d = h}, trial_);
    rhs_->stage(step.t + h, {.y1 = trial_.data(), .a = 0.5, .d = h / 2, .y0 = y.data(), .c = 0.5}, next);
    return {};
  }

 private:
  CriticalStep critical_step_;
  Rhs* rhs_ = nullptr;
  StateVector trial_;
};

std::vector<StabilityModel> stability_models(bool /*quick*/) {
  return {{.family = "heun",
           .parameters = "",
           .stages = 2,
           .beta = 2,
           .z_stiff = stability_margin * 2,
           .response = [](double z) { return 1 - z + z * z / 2; },
           .spec = [](double step) { return fmt::format("heun:step={:.17g}", step); }}};
}

}  // namespace

IntegratorEntry heun_entry() {
  return {.name = "heun",
          .summary = "Heun's method: an Euler step, then the trapezoidal rule with what it predicts",
          .source = "Heun (1900), Z. Math. Phys. 45, 23-38",
          .colour = "#305070",
          .order = 2,
          .adaptive = false,
          .keys = critical_step_keys(),
          .examples = {"heun:fraction=0.5"},
          .ladder = {"heun:fraction=0.9", "heun:fraction=0.25"},
          .stability = {.functions = stability_models, .limits = stability_models},
          .make = [](const Options& options) { return std::make_unique<Heun>(options); }};
}

}  // namespace superstep
