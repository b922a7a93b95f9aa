/// Orthogonal Runge-Kutta-Chebyshev method of order four: coefficients solved for, none tabulated.
/// Source: Abdulle (2002), doi:10.1137/S1064827500379549.

#include "integrators/detail/explicit/stabilised.hpp"
#include "integrators/detail/explicit/stabilised_stability.hpp"

namespace superstep {

IntegratorEntry rock_entry() {
  return {.name = "rock",
          .summary = "orthogonal Runge-Kutta-Chebyshev of order four (ROCK4), also for nonlinear scenes",
          .source = "Abdulle (2002), doi:10.1137/S1064827500379549",
          .colour = "#b07d4f",
          .order = 4,
          .adaptive = true,
          .distributed = Distributed::exact,
          .keys = stabilised_keys(rock4_family(), false),
          .examples = {"rock:rtol=1e-6", "rock:step=0.1"},
          .ladder = rtol_ladder("rock", 2, 10),
          .stability = stabilised_theory({{rock4_family, "rock:", 10, false}}),
          .make = [](const Options& options) -> std::unique_ptr<Method> {
            return std::make_unique<Stabilised>(rock4_family(), options);
          }};
}

}  // namespace superstep
