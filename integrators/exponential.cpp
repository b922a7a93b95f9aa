/// Exponential integration of linear constant networks: exact up to the tolerance, in one go for all output
/// times. Chebyshev: Tal-Ezer (1986), doi:10.1137/0723001. Lanczos: Hochbruck & Lubich (1997),
/// doi:10.1137/S0036142995280572.

#include "integrators/detail/chebyshev_propagator.hpp"
#include "integrators/detail/lanczos_propagator.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

std::vector<OptionKey> exponential_keys() {
  return {
      {.name = "rtol",
       .min = 1e-16,
       .max = 0.5,
       .fallback = "1e-8",
       .meaning = "error allowed at every output time, relative to the field's span (capacity-weighted rms)"},
      {.name = "basis",
       .type = OptionKey::Type::word,
       .words = {"chebyshev", "lanczos"},
       .fallback = "chebyshev",
       .meaning = "polynomial basis; lanczos adapts to the spectrum but sweeps twice"},
  };
}

std::unique_ptr<Integrator> make_exponential(const Options& options) {
  const double rtol = options.number("rtol").value_or(1e-8);
  if (options.word("basis", "chebyshev") == "lanczos") return std::make_unique<LanczosPropagator>(rtol);
  return std::make_unique<ChebyshevPropagator>(rtol);
}

}  // namespace

IntegratorEntry exponential_entry() {
  return {
      .name = "exponential",
      .summary = "matrix exponential by Chebyshev or Lanczos; exact for linear constant networks",
      .source =
          "Tal-Ezer (1986), doi:10.1137/0723001; Hochbruck & Lubich (1997), doi:10.1137/S0036142995280572",
      .order = 0,
      .adaptive = true,
      .keys = exponential_keys(),
      .examples = {"exponential:rtol=1e-13", "exponential:basis=lanczos,rtol=1e-9"},
      .ladder =
          joined({rtol_ladder("exponential", 1, 12), rtol_ladder("exponential:basis=lanczos", 2, 10, 2)}),
      .make = make_exponential};
}

}  // namespace superstep
