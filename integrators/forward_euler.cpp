/// Forward Euler, the baseline: y_{n+1} = y_n + h f(t_n, y_n). Stable for h <= 2/lambda_max.
/// Source: Rojek & Nisar 2026, eqs 13, 20-21, 27.

#include <algorithm>
#include <array>
#include <utility>

#include "core/state_vector.hpp"
#include "integrators/detail/critical_step.hpp"
#include "integrators/detail/run_guard.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

class ForwardEuler final : public Integrator {
 public:
  explicit ForwardEuler(const Options& options) : critical_step_(options) {}

  void prepare(Rhs& rhs, const Plan& plan) override {
    rhs_ = &rhs;
    track_inflow_ = plan.track_inflow;
    guard_.prepare(rhs, plan);
    recorder_.prepare(plan);
    state_.resize(rhs.size());
    next_.resize(rhs.size());
  }

  void start(double t, std::span<const double> y) override {
    t_ = t;
    rhs_->restart(t);
    state_.assign(y.begin(), y.end());
    step_ = critical_step_.resolve(*rhs_, t, state_);
    statistics_ = {.max_stages = 1, .time_per_sweep = step_};
  }

  Outcome advance(double t_out) override {
    double t_in = t_;
    auto steps = steps_to_cover(t_out - t_in, step_);
    for (std::uint64_t k = 0; k < steps;) {
      const auto chain = std::min<std::uint64_t>(longest_chain, steps - k);
      take_steps(chain, [&](std::uint64_t step) {
        return k + step == steps ? t_out : t_in + static_cast<double>(k + step) * step_;
      });
      k += chain;
      if (guard_.stop_requested(t_)) return interrupted_at(t_);
      if (k % RunGuard::stride != 0) continue;
      if (Outcome outcome = guard_.check(t_, state_); !outcome.ok()) return outcome;
      if (!critical_step_.may_have_changed(*rhs_, t_, state_)) continue;
      step_ = critical_step_.resolve(*rhs_, t_, state_);
      t_in = t_;
      steps = steps_to_cover(t_out - t_in, step_);
      k = 0;
    }
    return guard_.check(t_, state_);
  }

  [[nodiscard]] double time() const noexcept override { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept override { return state_; }
  [[nodiscard]] const Statistics& statistics() const noexcept override { return statistics_; }

 private:
  /// end_of(k), k = 1 ... count: time at which each step ends.
  template <class EndOf>
  void take_steps(std::uint64_t count, const EndOf& end_of) {
    const auto chain = std::span(links_).first(static_cast<std::size_t>(count));
    double t = t_;
    for (std::size_t k = 0; k < chain.size(); ++k) {
      const double t_next = end_of(k + 1);
      chain[k] = {.t = t, .stage = {.y1 = state_.data(), .a = 1, .d = t_next - t}, .out = next_.data()};
      std::swap(state_, next_);
      t = t_next;
    }
    rhs_->chain(chain, track_inflow_, recorder_.wanted() ? &recorder_.follow(chain) : nullptr);
    for (std::size_t k = 0; k < chain.size(); ++k) {
      if (track_inflow_) statistics_.inflow += chain[k].stage.d * chain[k].inflow;
      if (recorder_.wanted()) recorder_.record_followed(k + 1 < chain.size() ? chain[k + 1].t : t, k);
    }
    t_ = t;
    statistics_.steps += count;
  }

  CriticalStep critical_step_;
  Rhs* rhs_ = nullptr;
  RunGuard guard_;
  ProbeRecorder recorder_;
  StateVector state_, next_;
  std::array<ChainedStage, longest_chain> links_;
  double t_ = 0, step_ = 0;
  bool track_inflow_ = false;
  Statistics statistics_;
};

}  // namespace

IntegratorEntry forward_euler_entry() {
  return {.name = "forward-euler",
          .summary = "explicit Euler steps, the last one shortened to hit the output time",
          .source = "Rojek & Nisar 2026, eqs 13, 20-21, 27",
          .order = 1,
          .adaptive = false,
          .keys = critical_step_keys(),
          .examples = {"forward-euler:fraction=0.5"},
          .ladder = {"forward-euler:alpha=1", "forward-euler:fraction=1", "forward-euler:fraction=0.25"},
          .make = [](const Options& options) { return std::make_unique<ForwardEuler>(options); }};
}

}  // namespace superstep
