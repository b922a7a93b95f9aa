#pragma once
/// The phi rule with a linear solver: fixed steps, or steps controlled by Milne's device.

#include "integrators/detail/error_weights.hpp"
#include "integrators/detail/run_guard.hpp"
#include "integrators/detail/shifted_solver.hpp"
#include "integrators/detail/step_controller.hpp"
#include "integrators/integrator.hpp"

namespace superstep {

struct TrapezoidalSettings {
  double phi = 0.5;
  double rtol = 1e-4, atol = 0;
  double fixed_step = 0;  ///< s; 0 = controlled
};

class TrapezoidalNewton final : public Integrator {
 public:
  ///   solver  klu, cholmod, pcg, or auto
  TrapezoidalNewton(const TrapezoidalSettings& settings, std::string solver);

  void prepare(Rhs& rhs, const Plan& plan) override;
  void start(double t, std::span<const double> y) override;
  Outcome advance(double t_out) override;
  [[nodiscard]] double time() const noexcept override { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept override { return state_; }
  [[nodiscard]] const Statistics& statistics() const noexcept override { return statistics_; }
  [[nodiscard]] std::string choice() const override { return choice_; }

 private:
  [[nodiscard]] Outcome advance_fixed(double t_out);
  [[nodiscard]] Outcome advance_controlled(double t_out);
  /// Solves for the state at t + h into next_ and its derivative into next_derivative_.
  [[nodiscard]] Outcome try_step(double h);
  [[nodiscard]] double milne_error(double h);
  void accept(double t_next);
  [[nodiscard]] double first_step(double largest);

  TrapezoidalSettings settings_;
  std::string solver_name_, choice_;
  Rhs* rhs_ = nullptr;
  std::unique_ptr<ShiftedSolver> solver_;
  RunGuard guard_;
  ProbeRecorder recorder_;
  ErrorWeights weights_;
  StepController controller_;
  std::vector<double> state_, next_, derivative_, next_derivative_, earlier_derivative_, residual_, change_;
  double t_ = 0, t_end_ = 0, step_ = 0, step_before_ = 0;
  bool track_inflow_ = false;
  Statistics statistics_;
};

}  // namespace superstep
