#pragma once
/// A right-hand side given by a function: nonlinear, not symmetric, dependent on time, as no network is.

#include <functional>

#include "rhs/rhs.hpp"

namespace superstep::test {

class SmallSystem final : public Rhs {
 public:
  using Function = std::function<void(double t, std::span<const double> y, std::span<double> dydt)>;
  /// `radius` [1/s] bounds the spectral radius everywhere.
  SmallSystem(std::size_t size, double radius, Function f);

  [[nodiscard]] double spectral_bound(double, std::span<const double>) override { return radius_; }
  [[nodiscard]] std::span<const double> capacities() const noexcept override { return capacities_; }
  [[nodiscard]] double inflow(double t, std::span<const double> y) override;
  [[nodiscard]] double linear_inflow(std::span<const double>) const override { return 0; }

 private:
  void do_stage(double t, const Stage& stage, std::span<double> out) override;
  /// Not linear: throws std::logic_error.
  void do_linear_stage(const Stage& stage, std::span<double> out) override;
  /// Has no constant block: throws std::logic_error.
  void do_block_product(std::size_t field, std::span<const double> v, std::span<double> out) override;
  /// By differences.
  void do_jacobian(double t, std::span<const double> y, std::span<double> values) override;
  [[nodiscard]] SparsePattern build_pattern() override;

  double radius_;
  Function f_;
  std::vector<double> capacities_, rate_;
};

/// Smooth, coupled without symmetry, nonlinear and dependent on time; three entries, |y| stays near one.
[[nodiscard]] SmallSystem turning_system();

/// y at `t_end` by the classical Runge-Kutta method with `steps` equal steps: slow and obvious.
[[nodiscard]] std::vector<double> classical_runge_kutta(SmallSystem& system, std::vector<double> y,
                                                        double t_end, std::size_t steps);

}  // namespace superstep::test
