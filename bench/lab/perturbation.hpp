#pragma once
/// How a perturbation moves: the tools with which the stability laboratory measures growth.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "integrators/driver.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

/// de/dt = J e. A perturbation of a linear scene obeys exactly this, with the scene's own sweeps and without
/// its fixed values and sources. Throws InputError for a scene that is not linear.
class PerturbationRhs final : public Rhs {
 public:
  explicit PerturbationRhs(Rhs& scene);

  [[nodiscard]] double spectral_bound(double t, std::span<const double> y) override;
  [[nodiscard]] std::span<const double> capacities() const noexcept override { return scene_.capacities(); }
  [[nodiscard]] double inflow(double t, std::span<const double> y) override;
  [[nodiscard]] double linear_inflow(std::span<const double> v) const override;

 private:
  void do_stage(double t, const Stage& stage, std::span<double> out) override;
  void do_linear_stage(const Stage& stage, std::span<double> out) override;
  void do_block_product(std::size_t field, std::span<const double> v, std::span<double> out) override;
  void do_jacobian(double t, std::span<const double> y, std::span<double> values) override;
  [[nodiscard]] SparsePattern build_pattern() override;

  Rhs& scene_;
};

/// One step of a method as an operator on perturbations: e <- P e.
class StepOperator {
 public:
  /// `spec` must take exactly one step over `step` [s].
  StepOperator(Rhs& rhs, const std::string& spec, double step);
  /// False when the result is not finite or the method fails; e is then left as it was.
  [[nodiscard]] bool apply(std::span<double> e);

 private:
  double step_;
  std::unique_ptr<Integrator> method_;
};

/// sum of C_i a_i b_i, in which the Jacobian is self-adjoint.
[[nodiscard]] double capacity_product(const Rhs& rhs, std::span<const double> a, std::span<const double> b);
/// Scales `e` to norm 1 and returns the norm it had.
double normalise(const Rhs& rhs, std::span<double> e);

/// Entries in [-1, 1] that repeat from run to run.
[[nodiscard]] std::vector<double> rough_perturbation(std::size_t size);
/// The same over sqrt(C_i), norm 1: on average as much of every mode, however capacities differ.
[[nodiscard]] std::vector<double> white_perturbation(const Rhs& rhs);

/// Plan without limits on values and with spans of 1, so that growth can be watched instead of being stopped.
[[nodiscard]] Plan unguarded_plan(const Rhs& rhs, std::vector<double> output_times);

/// Factor by which the last of `steps` steps multiplies a white perturbation; infinite when it overflows.
[[nodiscard]] double growth_per_step(Rhs& rhs, const std::string& spec, double step, int steps);

/// Power iteration: the same with as many steps as it takes until the factor stands, at most `most_steps`. It
/// rises to the largest factor of any mode; where many modes are nearly as stiff its distance falls like
/// 1/steps.
[[nodiscard]] double settled_growth(Rhs& rhs, const std::string& spec, double step, int most_steps);

}  // namespace superstep
