#pragma once
/// Error measures: pure functions of numbers. Rojek & Nisar 2026, eqs 42-47.

#include <cstddef>
#include <optional>
#include <span>

#include "rhs/rhs.hpp"

namespace superstep {

/// Difference of two states over one field, in the field's unit.
struct Deviation {
  double rms = 0, max = 0;
};
[[nodiscard]] Deviation deviation(const FieldView& field, std::span<const double> state,
                                  std::span<const double> reference);

/// How far any value of a field lies outside [low, high]; 0 = nowhere.
[[nodiscard]] double overshoot(const FieldView& field, std::span<const double> state, double low,
                               double high);

/// Heat [J] or charge [C] that a field gained: sum of C_i (now_i - before_i).
[[nodiscard]] double stored(const FieldView& field, std::span<const double> capacities,
                            std::span<const double> before, std::span<const double> now);

/// (entered - stored) / entered; empty when next to nothing entered.
///   scale  heat that the field's span stands for, sum of C_i * span: inflows below 1e-12 of it are rounding
[[nodiscard]] std::optional<double> balance(double entered, double stored, double scale);

/// Number of leading instants that belong to the transient: up to the last one at which the reference is
/// still more than 1 % of `largest` away from its final value; all of them when that leaves fewer than 3.
///   distance [n]  |reference(t_k) - reference(t_end)|;  largest  its maximum over the whole run
[[nodiscard]] std::size_t transient_length(std::span<const double> distance, double largest);

/// |error| = Z exp(-k t), fitted by linear regression of log10|error| on t.
struct DecayFit {
  double rate = 0;           ///< k = -slope ln 10 [1/s]
  std::optional<double> r2;  ///< empty when all errors are equal: there is nothing to explain
};
/// Errors that are exactly 0 have no logarithm and are left out; empty with fewer than 3 others.
[[nodiscard]] std::optional<DecayFit> fit_decay(std::span<const double> time,
                                                std::span<const double> absolute_error);

}  // namespace superstep
