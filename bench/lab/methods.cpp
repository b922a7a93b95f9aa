#include "bench/lab/methods.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/lab/function.hpp"

namespace superstep {
namespace {

constexpr double growth_looked_for = 2;
constexpr double growth_tolerance = 0.01;  // power iteration approaches from below

int grid_points(const StabilityModel& method) {
  return 200 + 40 * method.stages;  // some forty on each ripple
}

// Effort of power iteration: few stages need many steps until the stiffest modes have won.
int most_growth_steps(const StabilityModel& method) {
  constexpr int most_sweeps = 20000;
  return most_sweeps / method.stages;
}

// R at one step length as the stiffest mode shows it: <v, P v> for a v of norm 1.
double measured_response(PerturbationRhs& rhs, const StiffestMode& mode, const StabilityModel& method,
                         double step) {
  StepOperator one_step(rhs, method.spec(step), step);
  auto e = mode.shape;
  return one_step.apply(e) ? capacity_product(rhs, mode.shape, e) : std::numeric_limits<double>::infinity();
}

void compare_responses(PerturbationRhs& rhs, const StiffestMode& mode, const StabilityModel& method,
                       MethodStability& out) {
  // A new length is a new factorization for an implicit method: the full step alone.
  const std::vector<double> parts = method.beta ? std::vector{0.1, 0.25, 0.5, 0.75, 1.0} : std::vector{1.0};
  for (const double part : parts) {
    const double measured = measured_response(rhs, mode, method, part * out.step);
    const double difference = std::abs(measured - method.response(part * out.z_stiff));
    if (!(difference <= out.difference)) out.difference = difference;
    out.stiff_measured = measured;
  }
}

void measure_beyond(PerturbationRhs& rhs, const StiffestMode& mode, const StabilityModel& method,
                    MethodStability& out) {
  const double z = growth_position(method.response, *out.limit, growth_looked_for);
  const double step = z / mode.rate;
  out.beyond = std::abs(method.response(z));
  out.beyond_measured = settled_growth(rhs, method.spec(step), step, most_growth_steps(method));
}

bool is_confirmed(const MethodStability& out) {
  if (!(out.difference <= out.tolerance) || !(out.growth <= out.largest + out.tolerance)) return false;
  return !out.beyond || std::abs(*out.beyond_measured / *out.beyond - 1) <= growth_tolerance;
}

}  // namespace

MethodStability examine_method(PerturbationRhs& rhs, const StiffestMode& mode, const StabilityModel& method) {
  const int points = grid_points(method);
  MethodStability out;
  out.family = method.family;
  out.parameters = method.parameters;
  out.order = method.order;
  out.stages = method.stages;
  out.z_stiff = method.z_stiff;
  out.step = method.z_stiff / mode.rate;
  out.spec = method.spec(out.step);
  out.beta = method.beta;
  if (method.beta) out.limit = growth_limit(method.response, *method.beta, points);
  out.largest = largest_response(method.response, 0, out.z_stiff, points);
  out.damping = largest_response(method.response, 0.5 * out.z_stiff, out.z_stiff, points);
  out.stiff = method.response(out.z_stiff);
  // What the shape lacks of being the mode enters squared; the rest is rounding.
  const double impurity = out.z_stiff * mode.residual / mode.rate;
  out.tolerance = 1e-9 + impurity * impurity + method.rounding;

  compare_responses(rhs, mode, method, out);
  constexpr int few_steps = 8;
  out.growth = growth_per_step(rhs, out.spec, out.step, few_steps);
  if (out.limit) measure_beyond(rhs, mode, method, out);
  out.agrees = is_confirmed(out);
  return out;
}

}  // namespace superstep
