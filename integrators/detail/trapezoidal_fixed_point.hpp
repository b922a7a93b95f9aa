#pragma once
/// The phi rule by fixed-point iteration with the adaptive step of the sintering paper.
/// Source: Zohdi (2014), eqs 22-30, 36 and Algorithm 1.

#include "integrators/detail/run_guard.hpp"
#include "integrators/detail/spectral_radius.hpp"
#include "integrators/detail/trapezoidal_newton.hpp"

namespace superstep {

struct FixedPointSettings {
  TrapezoidalSettings rule;  ///< rtol is the paper's TOL on the iteration; fixed_step = 0: adapted
  int iterations = 10;       ///< K_d, iterations wanted in a step
  int power = 1;             ///< p: 1 for first-order systems; the paper uses 2 for all fields
};

/// One step from t_L to t_L + h:
///   y^0 = y_L + h f(y_L);  y^K = y_L + h (phi f(y^{K-1}) + (1 - phi) f(y_L))
///   w_K = sum |y^K - y^{K-1}| / sum |y^K - y_L|,  w_0 = the first measured one
///   Lambda_K = (TOL/w_0)^(1/(p K_d)) / (w_K/w_0)^(1/(p K))
/// accepted when w_K <= TOL, then h <- min(h_lim, Lambda_K h); not within K_d iterations: h <- Lambda_K h,
/// step repeated.
class TrapezoidalFixedPoint final : public Integrator {
 public:
  explicit TrapezoidalFixedPoint(const FixedPointSettings& settings) : settings_(settings) {}

  void prepare(Rhs& rhs, const Plan& plan) override;
  void start(double t, std::span<const double> y) override;
  Outcome advance(double t_out) override;
  [[nodiscard]] double time() const noexcept override { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept override { return state_; }
  [[nodiscard]] const Statistics& statistics() const noexcept override { return statistics_; }

 private:
  struct Iteration {
    bool converged = false;
    double factor = 1;  ///< Lambda_K, bounded
  };
  [[nodiscard]] Iteration iterate(double h);
  void accept(double t_next);
  [[nodiscard]] Outcome hopeless(double h) const;

  FixedPointSettings settings_;
  Rhs* rhs_ = nullptr;
  RunGuard guard_;
  ProbeRecorder recorder_;
  SpectralRadius spectral_radius_;
  std::vector<double> state_, derivative_, iterate_, iterate_before_;
  double t_ = 0, t_end_ = 0, step_ = 0, radius_ = 0;
  bool track_inflow_ = false;
  double inflow_rate_ = 0;  ///< of the last but one iterate: what the accepted one was computed from
  Statistics statistics_;
};

}  // namespace superstep
