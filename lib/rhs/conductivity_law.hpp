#pragma once
/// Conductivity of a material as a function of temperature, for heat and for current.

#include <string>
#include <vector>

namespace superstep {

/// kappa(T) > 0 with its derivative. Temperatures are in the unit of the case.
///   constant  kappa_0
///   linear    kappa_0 (1 + coefficient (T - reference)), valid where that is > 0
///   table     linear between points, valid from the first to the last
///   sigmoid   kappa_0 (1 + amplitude/(1 + exp(-steepness (T - reference)))), valid everywhere: Zohdi (2014),
///             eq. 50
/// Beyond its range a law still gives finite values > 0, because trial stages go there: a line is held at
/// 1e-12 of kappa_0 (1 % with `clamp`), a table at its end values.
struct ConductivityLaw {
  enum class Kind : char { constant, linear, table, sigmoid };
  /// What a state beyond the range is: an error, or what the law's held value is meant for.
  enum class Outside : char { error, clamp };

  Kind kind = Kind::constant;
  double value = 0;        ///< kappa_0, W/(m K) or S/m, > 0; of a table: its first value
  double coefficient = 0;  ///< 1/K
  double reference = 0;    ///< K
  double amplitude = 0;    ///< -, > -1
  double steepness = 0;    ///< 1/K
  std::vector<double> temperatures = {}, values = {};
  Outside outside = Outside::error;
  std::string place = {};  ///< "file:line: key 'a.b'" of the case, to begin messages with; may be empty

  [[nodiscard]] bool varies() const noexcept { return kind != Kind::constant; }
  /// Whether its slope has no jumps: a table bends at its points, and whatever is held beyond a range there.
  [[nodiscard]] bool smooth() const noexcept;
  [[nodiscard]] double at(double temperature) const noexcept;
  [[nodiscard]] double slope(double temperature) const noexcept;  ///< dkappa/dT
  /// False beyond the range, whatever `outside` says; true for NaN, which is no matter of the law.
  ///   margin  share of a table's width that counts as inside on either side of it
  [[nodiscard]] bool covers(double temperature, double margin = 0) const noexcept;
  /// Whether there are temperatures at which this law is an error.
  [[nodiscard]] bool limited() const noexcept;
  /// Says that a temperature lies beyond the range, where that ends, and the way out.
  ///   what  "the fixed temperature of particle 7 is"
  [[nodiscard]] std::string explain(const std::string& what, double temperature) const;
  /// Largest value that the law takes anywhere; infinity for a line.
  [[nodiscard]] double largest() const noexcept;
  /// Part of kappa_0 at which a line is held beyond its range.
  [[nodiscard]] double floor() const noexcept;
};

}  // namespace superstep
