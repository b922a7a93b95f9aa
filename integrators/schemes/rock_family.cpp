#include "integrators/detail/explicit/rock_finish.hpp"
#include "integrators/schemes/rock_polynomial.hpp"
#include "integrators/schemes/stabilised_schemes.hpp"

namespace superstep {
namespace {

double beta(int stages) {
  constexpr double growth = 0.347;  // of beta(s)/s^2 as s grows, from above
  if (stages > rock_most_stages) return growth * stages * stages;
  return rock_polynomial(stages).length;
}

void build(int stages, ThreeTermScheme& scheme) {
  const RockPolynomial& polynomial = rock_polynomial(stages);
  scheme.stages = stages;
  scheme.beta = polynomial.length;
  scheme.uses_first_derivative = true;
  scheme.keeps_first_stage = false;
  scheme.finish.emplace();
  for (auto* v : {&scheme.m, &scheme.n, &scheme.mt, &scheme.gt, &scheme.c})
    v->assign(static_cast<std::size_t>(stages) + 1, 0.0);
  set_rock_recurrence(stages, polynomial, scheme);
  set_rock_finish(scheme);
}

}  // namespace

const StabilisedFamily& rock4_family() {
  static const StabilisedFamily family{
      .name = "rock4",
      .order = 4,
      .fewest_stages = rock_fewest_stages,
      .beta = beta,
      .build = build,
      .most_stages = rock_most_stages,
      .controlled_order = 3,
      // w(-l) = 1.5e-4 s^8 at the stiffest mode, a fifteenth of it over all modes
      .rounding_factor = 1e-5,
      .rounding_power = 8};
  return family;
}

}  // namespace superstep
