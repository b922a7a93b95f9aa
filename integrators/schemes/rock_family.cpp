#include "core/index.hpp"
#include "integrators/detail/explicit/rock_finish.hpp"
#include "integrators/schemes/rock_polynomial.hpp"
#include "integrators/schemes/stabilised_schemes.hpp"

namespace superstep {
namespace {

template <int order>
double beta(int stages) {
  constexpr double growth = order == 4 ? 0.347 : 0.802;  // of beta(s)/s^2 as s grows, from above
  if (stages > rock_most_stages(order)) return growth * stages * stages;
  return rock_polynomial(order, stages).length;
}

/// The recurrence for P_{s-p}, and room for what follows it.
template <int order>
const RockPolynomial& begin_scheme(int stages, ThreeTermScheme& scheme) {
  const RockPolynomial& polynomial = rock_polynomial(order, stages);
  scheme.stages = stages;
  scheme.beta = polynomial.length;
  scheme.uses_first_derivative = true;
  scheme.keeps_first_stage = false;
  scheme.by_change = true;
  scheme.finish.reset();
  for (auto* v : {&scheme.m, &scheme.n, &scheme.mt, &scheme.gt, &scheme.c}) v->assign(at(stages) + 1, 0.0);
  set_rock_recurrence(stages, polynomial, scheme);
  return polynomial;
}

/// Behind Y_{s-2}, w = 1 + 2 sigma z + tau z^2 is two stages more,
///   Y_{s-1} = Y_{s-2} + sigma h F_{s-2}
///   Y_s     = Y_{s-1} + sigma h F_{s-1} - (sigma - tau/sigma) h (F_{s-1} - F_{s-2}),
/// and these are three-term stages, too: h F_{s-2} is (Y_{s-1} - Y_{s-2})/sigma.
void build_two(int stages, ThreeTermScheme& scheme) {
  const auto weight = begin_scheme<2>(stages, scheme).weight();
  const double sigma = weight[1] / 2, tau = weight[2];
  const std::size_t last = at(stages);
  scheme.m[last - 1] = 1;
  scheme.mt[last - 1] = sigma;
  scheme.n[last] = tau / (sigma * sigma) - 1;
  scheme.m[last] = 1 - scheme.n[last];
  scheme.mt[last] = tau / sigma;
  set_stage_times(scheme);
}

void build_four(int stages, ThreeTermScheme& scheme) {
  (void)begin_scheme<4>(stages, scheme);
  scheme.finish.emplace();
  set_rock_finish(scheme);
}

}  // namespace

const StabilisedFamily& rock2_family() {
  static const StabilisedFamily family{.name = "rock2",
                                       .order = 2,
                                       .fewest_stages = rock_fewest_stages(2),
                                       .beta = beta<2>,
                                       .build = build_two,
                                       .most_stages = rock_most_stages(2),
                                       .rounding_factor = 0.06,  // of changes; that of values below
                                       .rounding_power = 4,
                                       .stiff_end = 0.18};
  return family;
}

const StabilisedFamily& rock4_family() {
  static const StabilisedFamily family{
      .name = "rock4",
      .order = 4,
      .fewest_stages = rock_fewest_stages(4),
      .beta = beta<4>,
      .build = build_four,
      .most_stages = rock_most_stages(4),
      .controlled_order = 3,
      .rounding_factor = 1e-5,  // of changes; a fifteenth of w(-l) over all modes
      .rounding_power = 8,
      .stiff_end = 1.5e-4};
  return family;
}

}  // namespace superstep
