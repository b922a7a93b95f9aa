#pragma once
/// Two-step Runge-Kutta-Chebyshev of second order:
///   y_{n+1} = nu y_{n-1} + (1 - nu) Y_s,   Y_s = T_s(w0 + w1 h A)/T_s(w0) y_n for y' = A y
/// Y_s is made by the recurrence of the one-step method of first order and reaches beyond the step; y_{n-1}
/// makes up for it. As |T_s| <= 1 < T_s(w0) on the interval, both roots of the recurrence lie inside the unit
/// circle for any nu in (0, 1). nu and w1 follow from the conditions of order two, for any ratio of steps:
///   1 + nu q = (1 - nu) w1 T_s'/T_s,   1 - nu q^2 = (1 - nu) w1^2 T_s''/T_s,   T_s at w0
/// With equal steps the interval is 1.8 times that of RKC2, the error of a step some twice as large.
/// Source: Moisa (2024), A family of two-step second order Runge-Kutta-Chebyshev methods, J. Comput. Appl.
/// Math., PII S0377-0427(24)00117-1; the coefficients are derived here.

#include "integrators/schemes/three_term.hpp"

namespace superstep {

/// Coefficients of one step.
struct TwoStepChebyshev {
  double before = 0;  ///< nu, the part of y_{n-1}
  double reach = 1;   ///< time of Y_s over the step
  double beta = 0;    ///< stable for h * rho <= beta
};

inline constexpr int fewest_two_step_stages = 2;

///   ratio  q, the step before over this one
[[nodiscard]] TwoStepChebyshev two_step_chebyshev(int stages, double ratio);
/// Fewest stages with beta >= z.
[[nodiscard]] int two_step_stages(double z, double ratio);
/// The recurrence of Y_s.
void two_step_recurrence(int stages, const TwoStepChebyshev& coefficients, ThreeTermScheme& scheme);
/// Error of a step where all before was right, over h^3 y''', in which it counts as (1 + nu q) errors of a
/// one-step method would.
[[nodiscard]] double two_step_error(const TwoStepChebyshev& coefficients, const ThreeTermScheme& scheme,
                                    double ratio);

}  // namespace superstep
