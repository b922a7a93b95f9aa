#include "rhs/conductivity_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace superstep {
namespace {

constexpr double clamped_line = 0.01;  // of kappa_0
// Of kappa_0. Small enough to follow a line down to its zero, large enough that means and their slopes
// neither overflow nor underflow.
constexpr double floor_of_line = 1e-12;

double logistic(double x) noexcept {
  return 1 / (1 + std::exp(-x));
}

/// Index of the interval [k, k+1] that holds T; 0 and size-1 outside.
std::size_t interval(const std::vector<double>& points, double temperature) noexcept {
  return static_cast<std::size_t>(std::upper_bound(points.begin(), points.end(), temperature) -
                                  points.begin());
}

}  // namespace

double ConductivityLaw::floor() const noexcept {
  return outside == Outside::clamp ? clamped_line : floor_of_line;
}

bool ConductivityLaw::smooth() const noexcept {
  const bool held = outside == Outside::clamp;
  return kind == Kind::table ? temperatures.size() <= 2 && !held
                             : !(kind == Kind::linear && held && coefficient != 0);
}

double ConductivityLaw::at(double temperature) const noexcept {
  switch (kind) {
    case Kind::constant:
      return value;
    case Kind::linear:
      return value * std::max(floor(), 1 + coefficient * (temperature - reference));
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
      return 1 + coefficient * (temperature - reference) > floor() ? value * coefficient : 0;
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

bool ConductivityLaw::covers(double temperature, double margin) const noexcept {
  switch (kind) {
    case Kind::linear:
      return !(1 + coefficient * (temperature - reference) <= 0);
    case Kind::table: {
      const double first = temperatures.front(), last = temperatures.back(), more = margin * (last - first);
      return !(temperature < first - more || temperature > last + more);
    }
    case Kind::constant:
    case Kind::sigmoid:
      break;
  }
  return true;
}

bool ConductivityLaw::limited() const noexcept {
  return outside == Outside::error && ((kind == Kind::linear && coefficient != 0) || kind == Kind::table);
}

std::string ConductivityLaw::explain(const std::string& what, double temperature) const {
  const std::string begin =
      fmt::format("{}{}{} {:.8g} K", place, place.empty() ? "" : ": ", what, temperature);
  if (kind == Kind::table)
    return fmt::format(
        "{}, and the table of the conductivity goes from {:.8g} K to {:.8g} K; extend it, or add outside = "
        "\"clamp\" to hold its end values beyond",
        begin, temperatures.front(), temperatures.back());
  return fmt::format(
      "{}, and the line of the conductivity is > 0 only {} {:.8g} K, where it crosses zero; give a law that "
      "holds there (table, sigmoid), or add outside = \"clamp\" to hold the line at 1 % of its value",
      begin, coefficient < 0 ? "below" : "above", reference - 1 / coefficient);
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
