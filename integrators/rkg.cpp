/// Runge-Kutta-Gegenbauer, strongly damped.
/// Source: Skaras, Saxton, Meyer & Aslam (2021), doi:10.1016/j.jcp.2020.109879.

#include "integrators/detail/explicit/stabilised.hpp"
#include "integrators/detail/explicit/stabilised_stability.hpp"

namespace superstep {

IntegratorEntry rkg_entry() {
  return {.name = "rkg",
          .summary = "Runge-Kutta-Gegenbauer, strongly damped",
          .source = "Skaras, Saxton, Meyer & Aslam (2021), doi:10.1016/j.jcp.2020.109879",
          .colour = "#cc79a7",
          .order = 2,
          .adaptive = true,
          .distributed = Distributed::exact,
          .keys = stabilised_keys({&rkg2_family()}),
          .examples = {"rkg:rtol=1e-6", "rkg:step=15"},
          .ladder = rtol_ladder("rkg", 1, 8),
          .stability = stabilised_theory({{rkg2_family, "rkg:", 11, false}}),
          .make = [](const Options& options) -> std::unique_ptr<Method> {
            return make_stabilised({&rkg2_family()}, options);
          }};
}

}  // namespace superstep
