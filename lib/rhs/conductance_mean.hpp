#pragma once
/// How a branch mixes the conductivities of its two ends, K_ij = G_ij mean(kappa_i, kappa_j) with a purely
/// geometric G_ij, and which part of its Joule heat goes to the first end: R_i/(R_i + R_j), R ~ 1/kappa.
///
/// Series conductance (Rojek & Nisar 2026, eqs 31-33, 38-39): 1/K_i + 1/K_j + 1/K_c all scale with
/// 1/kappa_eq, so that K_ij = kappa_eq G_ij with the harmonic mean. Pipe (Zohdi 2014, eqs 33-34): arithmetic
/// mean.

namespace superstep {

/// Values and derivatives for positive conductivities a (this end) and b (the other end).
struct HarmonicMean {
  static double value(double a, double b) noexcept { return 2 * a * b / (a + b); }
  static double slope(double a, double b) noexcept { return 2 * b * b / ((a + b) * (a + b)); }  ///< d/da
  /// mean times the heat share of this end, and its derivatives.
  static double heat(double a, double b) noexcept { return 2 * a * b * b / ((a + b) * (a + b)); }
  static double heat_slope_a(double a, double b) noexcept {
    const double sum = a + b;
    return 2 * b * b * (b - a) / (sum * sum * sum);
  }
  static double heat_slope_b(double a, double b) noexcept {
    const double sum = a + b;
    return 4 * a * a * b / (sum * sum * sum);
  }
};

struct ArithmeticMean {
  static double value(double a, double b) noexcept { return 0.5 * (a + b); }
  static double slope(double, double) noexcept { return 0.5; }
  static double heat(double, double b) noexcept { return 0.5 * b; }
  static double heat_slope_a(double, double) noexcept { return 0; }
  static double heat_slope_b(double, double) noexcept { return 0.5; }
};

enum class ConductanceMean : char { harmonic, arithmetic };

/// Calls f(mean) with the mean as a type, so that loops over branches contain no choice.
template <class F>
auto with_mean(ConductanceMean mean, F f) {
  return mean == ConductanceMean::harmonic ? f(HarmonicMean{}) : f(ArithmeticMean{});
}

}  // namespace superstep
