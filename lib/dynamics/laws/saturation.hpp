#pragma once
/// Conductivity that saturates with temperature and field.

#include <cmath>

namespace superstep::dynamics {

/// sigma(T, E) = sigma_0 (1 + K_1/(1 + exp(-g_1 (T - T_0))) + K_2/(1 + exp(-g_2 |E - E_0|))); K_1 = K_2 = 0:
/// constant. Source: Zohdi (2014), eq. 50. E is the field of a branch, |V_i - V_j|/|x_i - x_j|.
struct Saturation {
  double thermal = 0;          ///< K_1, >= 0
  double thermal_slope = 0;    ///< g_1 [1/K]
  double temperature = 300;    ///< T_0 [K]
  double field = 0;            ///< K_2, >= 0
  double field_slope = 0;      ///< g_2 [m/V]
  double reference_field = 0;  ///< E_0 [V/m]

  [[nodiscard]] bool acts() const noexcept { return thermal != 0 || field != 0; }
  /// Factor of sigma_0.
  [[nodiscard]] double factor(double kelvin, double volt_per_metre) const noexcept {
    double sum = 1;
    if (thermal != 0) sum += thermal / (1 + std::exp(-thermal_slope * (kelvin - temperature)));
    if (field != 0) sum += field / (1 + std::exp(-field_slope * std::abs(volt_per_metre - reference_field)));
    return sum;
  }
};

}  // namespace superstep::dynamics
