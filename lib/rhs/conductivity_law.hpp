#pragma once
/// Conductivity of a material as a function of temperature, for heat and for current.

#include <vector>

namespace superstep {

/// kappa(T) > 0 with its derivative. Temperatures are in the unit of the case.
///   constant  kappa_0
///   linear    kappa_0 (1 + coefficient (T - reference)), held at 1 % of kappa_0 where the line falls below
///   table     linear between points, end values beyond them
///   sigmoid   kappa_0 (1 + amplitude/(1 + exp(-steepness (T - reference)))): Zohdi (2014), eq. 50
struct ConductivityLaw {
  enum class Kind : char { constant, linear, table, sigmoid };

  Kind kind = Kind::constant;
  double value = 0;        ///< kappa_0, W/(m K) or S/m, > 0; of a table: its first value
  double coefficient = 0;  ///< 1/K
  double reference = 0;    ///< K
  double amplitude = 0;    ///< -, > -1
  double steepness = 0;    ///< 1/K
  std::vector<double> temperatures = {}, values = {};

  [[nodiscard]] bool varies() const noexcept { return kind != Kind::constant; }
  [[nodiscard]] double at(double temperature) const noexcept;
  [[nodiscard]] double slope(double temperature) const noexcept;  ///< dkappa/dT
  /// Largest value that the law takes anywhere; infinity for a line.
  [[nodiscard]] double largest() const noexcept;
};

}  // namespace superstep
