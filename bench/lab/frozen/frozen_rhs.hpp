#pragma once
/// A scene held at one state: how small perturbations move there.

#include <span>
#include <vector>

#include "rhs/rhs.hpp"

namespace superstep {

/// The Jacobian of a scene at (t, y), and what is known about it.
struct FrozenJacobian {
  SparsePattern pattern;
  std::vector<double> values;  ///< [nnz] 1/s
  /// [n] capacities over their field's total and its span squared: in the norm that they make, perturbations
  /// of a kelvin and of a volt weigh as much as they mean in the scene.
  std::vector<double> weights;
  double bound = 0;  ///< certified, of the spectral radius: scaled row sums where laws follow the state [1/s]
  /// No row has diagonal + sum of |off-diagonals| above 0: no perturbation grows by itself.
  bool decays = false;
  RhsTraits traits;

  [[nodiscard]] double largest() const noexcept;  ///< entry, by magnitude [1/s]
  /// True when no entry differs by more than `part` of the largest one.
  [[nodiscard]] bool equals(const FrozenJacobian& other, double part) const noexcept;
};

/// Takes the Jacobian at (t, y), between any pieces of time.
///   spans  [fields] K or V; 0 counts as 1
[[nodiscard]] FrozenJacobian freeze(Rhs& scene, double t, std::span<const double> y,
                                    std::span<const double> spans);

/// de/dt = J e for e = y - y*, the distance to the frozen state: linear, with constant coefficients and no
/// sources.
class FrozenRhs final : public Rhs {
 public:
  FrozenRhs(const Rhs& scene, FrozenJacobian jacobian);

  [[nodiscard]] const FrozenJacobian& frozen() const noexcept { return jacobian_; }

  [[nodiscard]] double spectral_bound(double t, std::span<const double> y) override;
  [[nodiscard]] std::span<const double> capacities() const noexcept override { return jacobian_.weights; }
  [[nodiscard]] double inflow(double t, std::span<const double> y) override;
  [[nodiscard]] double linear_inflow(std::span<const double> v) const override;

 private:
  void do_stage(double t, const Stage& stage, std::span<double> out) override;
  void do_linear_stage(const Stage& stage, std::span<double> out) override;
  void do_block_product(std::size_t field, std::span<const double> v, std::span<double> out) override;
  void do_jacobian(double t, std::span<const double> y, std::span<double> values) override;
  [[nodiscard]] SparsePattern build_pattern() override;
  [[nodiscard]] double row_product(std::size_t row, const double* v) const noexcept;

  FrozenJacobian jacobian_;
  std::vector<double> capacity_;                 ///< [n] of the scene, J/K or F
  std::vector<std::size_t> row_begin_, column_;  ///< J by rows
  std::vector<double> value_;
};

}  // namespace superstep
