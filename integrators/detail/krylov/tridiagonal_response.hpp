#pragma once
/// What a small tridiagonal system does from rest: the projected problem of Lanczos.

#include <limits>
#include <span>
#include <vector>

namespace superstep {

/// y(t) and its integral for y' = -T y + e_1, y(0) = 0, T symmetric tridiagonal and positive semidefinite.
struct TridiagonalResponse {
  std::vector<double> value, integral;  ///< [m]
};

/// The responses at `times`, ascending and > 0 [s].
///   alpha [m], beta [m-1]  of T: its diagonal, and what couples j to j+1 [1/s]
/// The inverse Laplace transform, y(t) = 1/(2 pi i) times the integral of e^(zt) (zI + T)^-1 e_1 / z, by the
/// trapezoidal rule on a hyperbola around the negative axis: some forty complex solves of a tridiagonal
/// system serve all times within a factor of eight, however stiff T is. Source of the contour: Weideman &
/// Trefethen (2007), doi:10.1090/S0025-5718-07-01945-X; its parameters here leave no room for the growth of
/// rounding.
[[nodiscard]] std::vector<TridiagonalResponse> tridiagonal_responses(std::span<const double> alpha,
                                                                     std::span<const double> beta,
                                                                     std::span<const double> times);

/// Error of a response in the Euclidean norm, over t for a constant input of 1, over t^2/2 for a ramp of 1/s.
constexpr double response_error = 16 * std::numeric_limits<double>::epsilon();

/// What changed about an input some time ago: by how much it jumped, and how its slope changed.
struct TridiagonalInput {
  double since = 0;           ///< > 0 [s]
  double jump = 0, kink = 0;  ///< [-], [1/s]
};

/// The response to an input q that is 0 before all of them and a line between: y' = q(t) e_1 - T y, y = 0
/// before, and its integral over time. By superposition at the nodes of the same contours, so that thousands
/// of knots cost little more than one.
///   inputs  ascending in `since`
[[nodiscard]] TridiagonalResponse tridiagonal_response(std::span<const double> alpha,
                                                       std::span<const double> beta,
                                                       std::span<const TridiagonalInput> inputs);

}  // namespace superstep
