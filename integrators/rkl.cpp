/// Runge-Kutta-Legendre, monotone without a damping parameter.
/// Source: Meyer, Balsara & Aslam (2014), doi:10.1016/j.jcp.2013.08.021.

#include "integrators/detail/explicit/stabilised.hpp"
#include "integrators/detail/explicit/stabilised_stability.hpp"

namespace superstep {

IntegratorEntry rkl_entry() {
  return {.name = "rkl",
          .summary = "Runge-Kutta-Legendre, monotone without a damping parameter",
          .source = "Meyer, Balsara & Aslam (2014), doi:10.1016/j.jcp.2013.08.021",
          .colour = "#009e73",
          .order = 2,
          .adaptive = true,
          .distributed = Distributed::exact,
          .keys = stabilised_keys({&rkl1_family(), &rkl2_family()}),
          .examples = {"rkl:rtol=1e-6", "rkl:order=1,rtol=1e-3", "rkl:step=15"},
          .ladder = joined({rtol_ladder("rkl", 1, 8), rtol_ladder("rkl:order=1", 1, 4)}),
          .stability =
              stabilised_theory({{rkl1_family, "rkl:order=1,", 11, false}, {rkl2_family, "rkl:", 11, false}}),
          .make = [](const Options& options) -> std::unique_ptr<Method> {
            return make_stabilised({&rkl1_family(), &rkl2_family()}, options);
          }};
}

}  // namespace superstep
