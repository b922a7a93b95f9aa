#pragma once
/// Stability functions: what one step makes of a mode, and where that grows.
/// Throughout z = step * rate >= 0 and response(z) = R(-z).

#include <functional>
#include <optional>

namespace superstep {

using Response = std::function<double(double z)>;

/// Polynomial of a superstep in closed form, T_n((1 + nu - x)/(1 - nu)) / T_n((1 + nu)/(1 - nu)), at x = rate
/// * critical step; 0 <= x <= 2 is stable. Long double, so that it can serve as the truth beside computed
/// supersteps.
[[nodiscard]] long double superstep_response(int n, double nu, long double x);

/// max |response| over [from, to], on `points` points that crowd near both ends as the ripples of the
/// polynomials do.
[[nodiscard]] double largest_response(const Response& response, double from, double to, int points);

/// First z up to 1.3 * beta with |response| > 1; empty when there is none.
[[nodiscard]] std::optional<double> growth_limit(const Response& response, double beta, int points);

/// First z beyond `limit` at which |response| has grown to `factor` > 1.
[[nodiscard]] double growth_position(const Response& response, double limit, double factor);

}  // namespace superstep
