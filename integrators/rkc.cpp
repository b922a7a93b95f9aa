/// Runge-Kutta-Chebyshev, damped Chebyshev polynomials.
/// Source: Sommeijer, Shampine & Verwer (1998), doi:10.1016/S0377-0427(97)00219-7.

#include "integrators/detail/explicit/stabilised.hpp"
#include "integrators/detail/explicit/stabilised_stability.hpp"

namespace superstep {

IntegratorEntry rkc_entry() {
  return {.name = "rkc",
          .summary = "Runge-Kutta-Chebyshev, damped Chebyshev polynomials",
          .source = "Sommeijer, Shampine & Verwer (1998), doi:10.1016/S0377-0427(97)00219-7",
          .colour = "#e69f00",
          .order = 2,
          .adaptive = true,
          .distributed = Distributed::exact,
          .keys = stabilised_keys({&rkc1_family(), &rkc2_family()}),
          .examples = {"rkc:rtol=1e-6", "rkc:order=1,rtol=1e-3", "rkc:step=15"},
          .ladder = joined({rtol_ladder("rkc", 1, 8), rtol_ladder("rkc:order=1", 1, 4)}),
          .stability =
              stabilised_theory({{rkc1_family, "rkc:order=1,", 10, false}, {rkc2_family, "rkc:", 10, true}}),
          .make = [](const Options& options) -> std::unique_ptr<Method> {
            return make_stabilised({&rkc1_family(), &rkc2_family()}, options);
          }};
}

}  // namespace superstep
