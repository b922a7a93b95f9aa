#pragma once
/// One integrator for all stabilised families: error-controlled or fixed steps on the three-term engine.

#include "core/state_vector.hpp"
#include "integrators/detail/error_weights.hpp"
#include "integrators/detail/run_guard.hpp"
#include "integrators/detail/spectral_radius.hpp"
#include "integrators/detail/stabilised_schemes.hpp"
#include "integrators/detail/step_controller.hpp"
#include "integrators/detail/three_term.hpp"
#include "integrators/registry.hpp"

namespace superstep {

/// Keys rtol, atol, step and stages (up to those of `family`); `two_orders` adds the key `order`.
[[nodiscard]] std::vector<OptionKey> stabilised_keys(const StabilisedFamily& family, bool two_orders);

class Stabilised final : public Integrator {
 public:
  /// Throws UsageError for `stages` without `step`, or both tolerance and `step`.
  Stabilised(const StabilisedFamily& family, const Options& options);

  void prepare(Rhs& rhs, const Plan& plan) override;
  void start(double t, std::span<const double> y) override;
  Outcome advance(double t_out) override;
  [[nodiscard]] double time() const noexcept override { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept override { return state_; }
  [[nodiscard]] const Statistics& statistics() const noexcept override { return statistics_; }

 private:
  [[nodiscard]] Outcome advance_fixed(double t_out);
  [[nodiscard]] Outcome advance_adaptive(double t_out);
  /// Trial step of size h with as many stages as stability asks for; the result is in the engine.
  void try_step(double h);
  void accept(double t_next);
  void set_stages(int stages);
  void look_for_settling();
  /// False when step and stages are both given: nothing is left to choose from the spectrum.
  [[nodiscard]] bool needs_radius() const noexcept { return fixed_stages_ == 0; }
  [[nodiscard]] double with_full_stages(double h) const;
  [[nodiscard]] double first_step(double largest);
  [[nodiscard]] double estimate_error(double h);
  [[nodiscard]] double estimate_error_of_finish(double h);

  const StabilisedFamily& family_;
  double rtol_, atol_, fixed_step_;
  int fixed_stages_, stage_limit_ = 0;
  Rhs* rhs_ = nullptr;
  RunGuard guard_;
  ProbeRecorder recorder_;
  ErrorWeights weights_;
  SpectralRadius spectral_radius_;
  StepController controller_;
  ThreeTermScheme scheme_;
  ThreeTermEngine engine_;
  StateVector state_, derivative_, next_derivative_;
  double t_ = 0, t_end_ = 0, step_ = 0, radius_ = 0, trial_inflow_ = 0;
  int steps_since_radius_ = 0;
  bool track_inflow_ = false;
  Statistics statistics_;
};

}  // namespace superstep
