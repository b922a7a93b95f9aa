#pragma once
/// Stabilised explicit methods as one three-term recurrence, each stage one fused sweep:
///   Y_0 = y_n;  Y_1 = Y_0 + mt_1 h F_0
///   Y_j = (1 - m_j - n_j) Y_0 + m_j Y_{j-1} + n_j Y_{j-2} + mt_j h F_{j-1} + gt_j h F_0
/// and, for order four, a finishing procedure of four more stages behind it.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/state_vector.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

/// Four explicit stages that start from the result G_1 of the recurrence with its r stages:
///   G_i = G_1 + h sum_{j<i} a_ij F(G_j),   y_{n+1} = G_1 + h sum_i b_i F(G_i)
///   error = estimate_scale (y_{n+1} - y_n - h sum_i embedded_i F(G_i))
/// G_i is stage r + i - 1 of the scheme: its time is c_{r+i-1} h.
struct FinishingProcedure {
  static constexpr int stages = 4;
  std::array<std::array<double, 3>, 3> a{};  ///< rows of G_2, G_3, G_4
  std::array<double, 4> b{};
  std::array<double, 4> embedded{};  ///< a result one order lower
  double estimate_scale = 1;
};

/// Coefficients of one method with s stages; entry 0 of each array is unused.
struct ThreeTermScheme {
  int stages = 0;                       ///< sweeps of one step, s
  double beta = 0;                      ///< stable for h * rho <= beta
  bool uses_first_derivative = false;   ///< the first stage starts from F_0 as given
  bool keeps_first_stage = false;       ///< gt or the Y_0 term is not zero
  bool by_change = false;               ///< its stages multiply roundings, which are to be those of a change
  std::vector<double> m, n, mt, gt, c;  ///< [s+1]; c_j h = time of stage j
  std::optional<FinishingProcedure> finish{};

  /// Stages of the three-term recurrence alone, r.
  [[nodiscard]] int recurrence_stages() const noexcept {
    return finish ? stages - FinishingProcedure::stages : stages;
  }
};

/// Times c of the recurrence's stages from its other coefficients.
void set_stage_times(ThreeTermScheme& scheme);

/// First-order RKC polynomial T_s(w0 + w1 z)/T_s(w0), by ratios of T_j that cannot overflow.
///   excess [-]  w0 - 1 > 0, given as such because 1 + excess would lose its digits
///   reach  [-]  time that the last stage is at, over the step: w1 is that times what makes it 1
/// Super-time-stepping with damping nu is the case w0 = (1 + nu)/(1 - nu), excess = 2 nu/(1 - nu).
/// Source: Verwer, Hundsdorfer & Sommeijer (1990), Convergence properties of the Runge-Kutta-Chebyshev
/// method.
void first_order_chebyshev(int stages, double excess, ThreeTermScheme& scheme, double reach = 1);

/// Whether f(y0 + d) = f(y0) + K d for any change d and at any time, so that stages can be changes alone.
[[nodiscard]] bool evaluates_changes(const Rhs& rhs) noexcept;

/// Work vectors of the recurrence, allocated once.
class ThreeTermEngine {
 public:
  ///   finishing  the schemes to come have a finishing procedure
  void resize(std::size_t size, bool finishing = false);
  /// One step from y0 over h. `f0` = f(t, y0) when the scheme uses it, else may be empty (the engine sweeps
  /// for itself).
  /// A scheme `by_change` keeps its stages as changes from y0: always where it has a finishing procedure,
  /// which multiplies roundings most, and otherwise where f can be evaluated at the change, so that no sweep
  /// is longer. The result is in `result()` until the next call; y0 is left as it is.
  void step(Rhs& rhs, const ThreeTermScheme& scheme, double t, double h, std::span<const double> y0,
            std::span<const double> f0);
  [[nodiscard]] StateVector& result() noexcept { return result_; }
  /// F(G_1) ... F(G_4) of the last step's finishing procedure.
  [[nodiscard]] const std::array<StateVector, 4>& slopes() const noexcept { return slopes_; }

 private:
  void step_by_change(Rhs& rhs, const ThreeTermScheme& scheme, double t, double h, std::span<const double> y0,
                      std::span<const double> f0);
  void finish(Rhs& rhs, const ThreeTermScheme& scheme, double t, double h, std::span<const double> y0,
              std::span<const double> f0);

  StateVector result_, previous_, argument_;
  std::array<StateVector, 4> slopes_;
};

}  // namespace superstep
