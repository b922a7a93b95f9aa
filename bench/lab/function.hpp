#pragma once
/// Stability functions: what one step makes of a mode, and where that grows.
/// Throughout z = step * rate >= 0 and response(z) = R(-z).

#include <optional>

#include "integrators/schemes/stability_model.hpp"

namespace superstep {

/// max |response| over [from, to], on `points` points that crowd near both ends as the ripples of the
/// polynomials do.
[[nodiscard]] double largest_response(const Response& response, double from, double to, int points);

/// First z up to 1.3 * beta with |response| > 1; empty when there is none.
[[nodiscard]] std::optional<double> growth_limit(const Response& response, double beta, int points);

/// First z beyond `limit` at which |response| has grown to `factor` > 1.
[[nodiscard]] double growth_position(const Response& response, double limit, double factor);

}  // namespace superstep
