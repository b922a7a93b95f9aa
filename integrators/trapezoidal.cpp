/// Trapezoidal (phi) rule: y_{n+1} = y_n + h (phi f(y_{n+1}) + (1 - phi) f(y_n)).
/// Source: Zohdi (2014), eqs 22-30, 36, Algorithm 1. phi = 0.5 is second order but not L-stable: with h
/// lambda >> 1 stiff modes ring; phi slightly above 0.5 damps them.

#include "integrators/detail/implicit/trapezoidal.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "integrators/detail/tolerance.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

std::vector<OptionKey> trapezoidal_keys() {
  std::vector<OptionKey> keys = {
      {.name = "phi",
       .min = 0,
       .max = 1,
       .fallback = "0.5",
       .meaning = "0 forward Euler, 0.5 trapezoidal, 1 backward Euler"},
      {.name = "solver",
       .type = OptionKey::Type::word,
       .words = {"auto", "klu", "cholmod", "pcg", "fixed-point"},
       .fallback = "auto",
       .meaning =
           "how a step is solved; auto takes the fastest of klu, cholmod and pcg; fixed-point adapts its "
           "step as the sintering paper does"},
      fixed_step_key(),
      {.name = "iterations",
       .type = OptionKey::Type::integer,
       .min = 2,
       .max = 1000,
       .fallback = "10",
       .meaning = "fixed-point: iterations wanted in a step (K_d)"},
      {.name = "p",
       .type = OptionKey::Type::integer,
       .min = 1,
       .max = 2,
       .fallback = "1",
       .meaning = "fixed-point: power of the step in the contraction; the paper uses 2"},
      {.name = "control",
       .type = OptionKey::Type::word,
       .words = {"error", "paper"},
       .fallback = "error",
       .meaning =
           "fixed-point: steps by the estimated error as well, or as the sintering paper has it by the "
           "iteration alone, rtol being its tolerance"},
      tolerance_key("1e-4"),
  };
  return keys;
}

std::unique_ptr<Method> make_trapezoidal(const Options& options) {
  TrapezoidalSettings rule;
  rule.phi = options.number("phi");
  rule.rtol = options.number("rtol");
  rule.fixed_step = options.given("step").value_or(0);
  rule.solver = options.word("solver");
  if (rule.solver == "fixed-point")
    return std::make_unique<TrapezoidalFixedPoint>(
        rule, FixedPointSettings{options.integer("iterations"), options.integer("p"),
                                 options.word("control") == "paper"});
  rule.fixed_step = fixed_step_of(options);
  for (const char* key : {"iterations", "p", "control"})
    if (options.has(key))
      throw UsageError(std::string("trapezoidal: ") + key +
                       " goes with solver=fixed-point; leave it out, or choose that");
  return std::make_unique<TrapezoidalNewton>(rule);
}

std::vector<StabilityModel> trapezoidal_stability(bool /*quick*/) {
  std::vector<StabilityModel> models;
  for (const double phi : {0.5, 0.6, 1.0})
    for (const double z_stiff : {10.0, 1e4})
      models.push_back(
          {.family = "trapezoidal",
           .parameters = fmt::format("phi={:g}", phi),
           .beta = std::nullopt,
           .z_stiff = z_stiff,
           .response = [phi](double z) { return (1 - (1 - phi) * z) / (1 + phi * z); },
           .spec = [phi](double step) { return fmt::format("trapezoidal:phi={},step={:.17g}", phi, step); }});
  return models;
}

}  // namespace

IntegratorEntry trapezoidal_entry() {
  return {.name = "trapezoidal",
          .summary = "implicit phi rule by fixed-point iteration, KLU, CHOLMOD or conjugate gradients",
          .source = "Zohdi (2014), eqs 22-30, 36, Algorithm 1",
          .colour = "#d55e00",
          .order = 2,
          .adaptive = true,
          .distributed = Distributed::exact,
          .gathered_where = "but for solver=pcg on linear scenes",
          .keys = trapezoidal_keys(),
          .examples = {"trapezoidal:solver=pcg,rtol=1e-5", "trapezoidal:solver=cholmod,rtol=1e-5",
                       "trapezoidal:solver=fixed-point,rtol=1e-8", "trapezoidal:phi=0.6,rtol=1e-5",
                       "trapezoidal:step=15"},
          .ladder = joined({rtol_ladder("trapezoidal:solver=pcg", 1, 6),
                            rtol_ladder("trapezoidal:solver=klu", 2, 5),
                            rtol_ladder("trapezoidal:solver=cholmod", 2, 5),
                            {"trapezoidal:solver=fixed-point,rtol=1e-4"}}),
          .stability = {.functions = trapezoidal_stability, .limits = {}},
          .make = make_trapezoidal};
}

}  // namespace superstep
