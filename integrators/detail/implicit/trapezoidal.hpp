#pragma once
/// The phi rule y_{n+1} = y_n + h (phi f(y_{n+1}) + (1 - phi) f(y_n)) with a linear solver, or by fixed-point
/// iteration.

#include <string>

#include "integrators/detail/error_norm.hpp"
#include "integrators/detail/explicit/spectral_radius.hpp"
#include "integrators/detail/implicit/implicit_stage.hpp"
#include "integrators/integrator.hpp"

namespace superstep {

struct TrapezoidalSettings {
  double phi = 0;
  double rtol = 0;
  double fixed_step = 0;  ///< s; 0 = controlled
  std::string solver;     ///< auto, klu, cholmod, pcg
};

/// What both kinds of solvers share: the first slope, the one before, and Milne's estimate of the error.
class Trapezoidal : public OneStepMethod {
 public:
  explicit Trapezoidal(const TrapezoidalSettings& settings) : settings_(settings) {}

  void prepare(Rhs& rhs, const Task& task) override;
  [[nodiscard]] double rtol() const final { return settings_.fixed_step > 0 ? 0 : settings_.rtol; }
  [[nodiscard]] Pace pace() const override { return settings_.fixed_step > 0 ? Pace::equal : Pace::error; }
  [[nodiscard]] double own_step(double t, std::span<const double> y) override;
  [[nodiscard]] int order() const final { return settings_.phi == 0.5 ? 2 : 1; }
  [[nodiscard]] double share() const final;
  [[nodiscard]] std::span<const double> slope() const final { return slope_; }
  void restart(double t, std::span<const double> y, bool smooth) final;
  void accept(const Step& step, std::span<const double> state) final;

 protected:
  /// next = state extrapolated by the slopes that are known (Adams & Bashforth).
  void predict(double h, const StateVector& state, StateVector& next) const;
  /// Difference to that predictor; for phi = 0.5 divided by 3 (1 + h_{n-1}/h_n).
  [[nodiscard]] double milne_error(double h, const StateVector& state, const StateVector& next) const;

  TrapezoidalSettings settings_;
  Rhs* rhs_ = nullptr;
  ErrorNorm norm_;
  StateVector slope_, next_slope_, base_;

 private:
  StateVector earlier_slope_;
  double step_before_ = 0;  ///< s; 0 = there is none
};

/// With klu, cholmod or pcg.
class TrapezoidalNewton final : public Trapezoidal {
 public:
  using Trapezoidal::Trapezoidal;
  void prepare(Rhs& rhs, const Task& task) override;
  [[nodiscard]] double worth_changing() const override { return 1.5; }
  [[nodiscard]] Trial attempt(const Step& step, StateVector& state, StateVector& next) override;
  void reset_counts() override { stage_.reset_counts(); }
  void add_counts(Statistics& statistics) const override;
  [[nodiscard]] std::string choice() const override { return choice_; }

 private:
  ImplicitStage stage_;
  std::string choice_;
};

struct FixedPointSettings {
  int iterations = 0;          ///< K_d, iterations wanted in a step
  int power = 0;               ///< p: 1 for first-order systems; the paper uses 2 for all fields
  bool paper_control = false;  ///< the iteration alone rules the step, rtol being the paper's TOL
};

/// One step from t_L to t_L + h by Zohdi (2014), eqs 22-30, 36 and Algorithm 1:
///   y^0 = y_L + h f(y_L);  y^K = y_L + h (phi f(y^{K-1}) + (1 - phi) f(y_L))
///   w_K = sum |y^K - y^{K-1}| / sum |y^K - y_L|,  w_0 = the first measured one
///   Lambda_K = (TOL/w_0)^(1/(p K_d)) / (w_K/w_0)^(1/(p K))
/// accepted when w_K <= TOL, then h <- Lambda_K h; not within K_d iterations: h <- Lambda_K h, step repeated.
class TrapezoidalFixedPoint final : public Trapezoidal {
 public:
  TrapezoidalFixedPoint(const TrapezoidalSettings& settings, const FixedPointSettings& iteration)
      : Trapezoidal(settings), iteration_(iteration) {}
  void prepare(Rhs& rhs, const Task& task) override;
  [[nodiscard]] Pace pace() const override;
  [[nodiscard]] double own_step(double t, std::span<const double> y) override;
  [[nodiscard]] double longest_step(double t, std::span<const double> y) override;
  [[nodiscard]] Trial attempt(const Step& step, StateVector& state, StateVector& next) override;
  void reset_counts() override { most_iterations_ = 0; }
  void add_counts(Statistics& statistics) const override;

 private:
  [[nodiscard]] Trial not_converged(double h, double factor) const;

  FixedPointSettings iteration_;
  SpectralRadius radius_;
  double radius_now_ = 0;
  int most_iterations_ = 0;
};

}  // namespace superstep
