/// Forward Euler, the baseline: y_{n+1} = y_n + h f(t_n, y_n). Stable for h <= 2/lambda_max.
/// Source: Rojek & Nisar 2026, eqs 13, 20-21, 27.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "integrators/detail/explicit/critical_step.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

class ForwardEuler final : public OneStepMethod {
 public:
  explicit ForwardEuler(const Options& options) : critical_step_(options) {}

  void prepare(Rhs& rhs, const Task& task) override {
    rhs_ = &rhs;
    critical_step_.prepare(rhs, task.spans);
  }
  [[nodiscard]] Pace pace() const override { return Pace::multiples; }
  [[nodiscard]] double own_step(double t, std::span<const double> y) override {
    return critical_step_.at(t, y);
  }
  [[nodiscard]] bool stability_varies() const override { return critical_step_.varies(); }
  [[nodiscard]] double stable_step(double t, std::span<const double> y) override {
    return critical_step_.limit(t, y);
  }
  [[nodiscard]] std::size_t longest_chain_of_steps() const override { return longest_chain; }

  void restart(double t, std::span<const double> y, bool /*smooth*/) override {
    if (first_step_ == 0) first_step_ = critical_step_.at(t, y);
  }

  Trial attempt(const Step& step, StateVector& state, StateVector& next) override {
    const auto chain = std::span(links_).first(step.ends.size());
    double t = step.t;
    for (std::size_t k = 0; k < chain.size(); ++k) {
      if (k > 0) std::swap(state, next);
      chain[k] = {.t = t, .stage = {.y1 = state.data(), .a = 1, .d = step.ends[k] - t}, .out = next.data()};
      t = step.ends[k];
    }
    rhs_->chain(chain, false);
    return {};
  }

  void reset_counts() override { first_step_ = 0; }
  void add_counts(Statistics& statistics) const override {
    statistics.max_stages = std::max(statistics.max_stages, 1);
    if (statistics.time_per_sweep == 0) statistics.time_per_sweep = first_step_;
  }

 private:
  CriticalStep critical_step_;
  Rhs* rhs_ = nullptr;
  std::array<ChainedStage, longest_chain> links_;
  double first_step_ = 0;
};

std::vector<StabilityModel> stability_models(bool /*quick*/) {
  return {{.family = "forward-euler",
           .parameters = "",
           .beta = 2,
           .z_stiff = stability_margin * 2,
           .response = [](double z) { return 1 - z; },
           .spec = [](double step) { return fmt::format("forward-euler:step={:.17g}", step); }}};
}

}  // namespace

IntegratorEntry forward_euler_entry() {
  return {.name = "forward-euler",
          .summary = "explicit Euler steps, the last one shortened to hit the output time",
          .source = "Rojek & Nisar 2026, eqs 13, 20-21, 27",
          .colour = "#7f7f7f",
          .order = 1,
          .adaptive = false,
          .distributed = Distributed::exact,
          .keys = critical_step_keys(),
          .examples = {"forward-euler:fraction=0.5", "forward-euler:fraction=0.95,bound=lanczos"},
          .representatives = {"forward-euler:fraction=1,bound=lanczos"},
          .ladder = {"forward-euler:alpha=1", "forward-euler:fraction=1,bound=lanczos",
                     "forward-euler:fraction=1", "forward-euler:fraction=0.25"},
          .stability = {.functions = stability_models, .limits = stability_models},
          .make = [](const Options& options) { return std::make_unique<ForwardEuler>(options); }};
}

}  // namespace superstep
