/// Orthogonal Runge-Kutta-Chebyshev methods of order four and two: coefficients solved for, none tabulated.
/// Sources: Abdulle (2002), doi:10.1137/S1064827500379549; Abdulle & Medovikov (2001),
/// doi:10.1007/s002110100292.

#include "integrators/detail/explicit/stabilised.hpp"
#include "integrators/detail/explicit/stabilised_stability.hpp"

namespace superstep {

IntegratorEntry rock_entry() {
  return {
      .name = "rock",
      .summary =
          "orthogonal Runge-Kutta-Chebyshev of order four (ROCK4) or two (ROCK2), also for nonlinear scenes",
      .source =
          "Abdulle (2002), doi:10.1137/S1064827500379549; Abdulle & Medovikov (2001), "
          "doi:10.1007/s002110100292",
      .colour = "#b07d4f",
      .order = 4,
      .adaptive = true,
      .distributed = Distributed::exact,
      .keys = stabilised_keys({&rock2_family(), &rock4_family()}),
      .examples = {"rock:rtol=1e-6", "rock:order=2,rtol=1e-3", "rock:step=0.1"},
      .ladder = joined({rtol_ladder("rock", 2, 10), rtol_ladder("rock:order=2", 1, 6)}),
      .stability =
          stabilised_theory({{rock2_family, "rock:order=2,", 10, false}, {rock4_family, "rock:", 10, false}}),
      .make = [](const Options& options) -> std::unique_ptr<Method> {
        return make_stabilised({&rock2_family(), &rock4_family()}, options);
      }};
}

}  // namespace superstep
