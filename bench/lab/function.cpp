#include "bench/lab/function.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace superstep {
namespace {

constexpr double above_one = 1 + 1e-9;  // values of 1 come with rounding

double grid_point(double from, double to, int k, int points) {
  return from + (to - from) * 0.5 * (1 - std::cos(std::numbers::pi * k / points));
}

// |response| <= bound at `low`, > bound at `high`: the place between, to rounding.
double crossing(const Response& response, double low, double high, double bound) {
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (std::abs(response(middle)) > bound ? high : low) = middle;
  }
  return high;
}

}  // namespace

double largest_response(const Response& response, double from, double to, int points) {
  double largest = 0;
  for (int k = 0; k <= points; ++k)
    largest = std::max(largest, std::abs(response(grid_point(from, to, k, points))));
  return largest;
}

std::optional<double> growth_limit(const Response& response, double beta, int points) {
  const double end = 1.3 * beta;
  double before = 0;
  for (int k = 1; k <= points; ++k) {
    const double z = grid_point(0, end, k, points);
    if (std::abs(response(z)) > above_one) return crossing(response, before, z, above_one);
    before = z;
  }
  return std::nullopt;
}

double growth_position(const Response& response, double limit, double factor) {
  double low = limit, high = limit;
  while (std::abs(response(high)) <= factor) {
    low = high;
    high *= 1.001;  // steps small enough not to jump over a ripple
  }
  return crossing(response, low, high, factor);
}

}  // namespace superstep
