/// Trapezoidal (phi) rule: y_{n+1} = y_n + h (phi f(y_{n+1}) + (1 - phi) f(y_n)).
/// Source: Zohdi (2014), eqs 22-30, 36, Algorithm 1. phi = 0.5 is second order but not L-stable: with h
/// lambda >> 1 stiff modes ring; phi slightly above 0.5 damps them.

#include "core/error.hpp"
#include "integrators/detail/trapezoidal_fixed_point.hpp"
#include "integrators/detail/trapezoidal_newton.hpp"
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
      {.name = "step",
       .min = 0,
       .min_open = true,
       .unit = "s",
       .meaning = "fixed step instead of a controlled one"},
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
  };
  for (auto& key : tolerance_keys("1e-4")) keys.push_back(std::move(key));
  return keys;
}

std::unique_ptr<Integrator> make_trapezoidal(const Options& options) {
  TrapezoidalSettings rule;
  rule.phi = options.number("phi").value_or(rule.phi);
  rule.rtol = options.number("rtol").value_or(rule.rtol);
  rule.atol = options.number("atol").value_or(rule.atol);
  rule.fixed_step = options.number("step").value_or(0.0);
  const std::string solver = options.word("solver", "auto");
  if (solver == "fixed-point")
    return std::make_unique<TrapezoidalFixedPoint>(FixedPointSettings{
        rule, options.integer("iterations").value_or(10), options.integer("p").value_or(1)});
  for (const char* key : {"iterations", "p"})
    if (options.has(key))
      throw UsageError(std::string("trapezoidal: ") + key +
                       " goes with solver=fixed-point; leave it out, or choose that");
  return std::make_unique<TrapezoidalNewton>(rule, solver);
}

}  // namespace

IntegratorEntry trapezoidal_entry() {
  return {.name = "trapezoidal",
          .summary = "implicit phi rule by fixed-point iteration, KLU, CHOLMOD or conjugate gradients",
          .source = "Zohdi (2014), eqs 22-30, 36, Algorithm 1",
          .order = 2,
          .adaptive = true,
          .keys = trapezoidal_keys(),
          .examples = {"trapezoidal:solver=pcg,rtol=1e-5", "trapezoidal:solver=cholmod,rtol=1e-5",
                       "trapezoidal:solver=fixed-point,rtol=1e-8", "trapezoidal:phi=0.6,rtol=1e-5",
                       "trapezoidal:step=15"},
          .ladder = joined({rtol_ladder("trapezoidal:solver=pcg", 1, 6),
                            rtol_ladder("trapezoidal:solver=klu", 2, 5),
                            rtol_ladder("trapezoidal:solver=cholmod", 2, 5),
                            {"trapezoidal:solver=fixed-point,rtol=1e-4"}}),
          .make = make_trapezoidal};
}

}  // namespace superstep
