#include "rhs/conductivity_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace superstep {
namespace {

constexpr double floor_of_line = 0.01;  // of kappa_0

double logistic(double x) noexcept {
  return 1 / (1 + std::exp(-x));
}

/// Index of the interval [k, k+1] that holds T; 0 and size-1 outside.
std::size_t interval(const std::vector<double>& points, double temperature) noexcept {
  return static_cast<std::size_t>(std::upper_bound(points.begin(), points.end(), temperature) -
                                  points.begin());
}

}  // namespace

double ConductivityLaw::at(double temperature) const noexcept {
  switch (kind) {
    case Kind::constant:
      return value;
    case Kind::linear:
      return value * std::max(floor_of_line, 1 + coefficient * (temperature - reference));
    case Kind::table: {
      const auto k = interval(temperatures, temperature);
      if (k == 0) return values.front();
      if (k == temperatures.size()) return values.back();
      return values[k - 1] + slope(temperature) * (temperature - temperatures[k - 1]);
    }
    case Kind::sigmoid:
      return value * (1 + amplitude * logistic(steepness * (temperature - reference)));
  }
  return value;
}

double ConductivityLaw::slope(double temperature) const noexcept {
  switch (kind) {
    case Kind::constant:
      return 0;
    case Kind::linear:
      return 1 + coefficient * (temperature - reference) > floor_of_line ? value * coefficient : 0;
    case Kind::table: {
      const auto k = interval(temperatures, temperature);
      if (k == 0 || k == temperatures.size()) return 0;
      return (values[k] - values[k - 1]) / (temperatures[k] - temperatures[k - 1]);
    }
    case Kind::sigmoid: {
      const double s = logistic(steepness * (temperature - reference));
      return value * amplitude * steepness * s * (1 - s);
    }
  }
  return 0;
}

double ConductivityLaw::largest() const noexcept {
  switch (kind) {
    case Kind::constant:
      return value;
    case Kind::linear:
      return std::numeric_limits<double>::infinity();
    case Kind::table:
      return *std::max_element(values.begin(), values.end());
    case Kind::sigmoid:
      return value * (1 + std::max(0.0, amplitude));
  }
  return value;
}

}  // namespace superstep
