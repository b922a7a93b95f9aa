/// Exponential integration of linear constant networks: exact up to the tolerance, in one go for all output
/// times. Chebyshev: Tal-Ezer (1986), doi:10.1137/0723001. Lanczos: Hochbruck & Lubich (1997),
/// doi:10.1137/S0036142995280572.

#include "integrators/detail/chebyshev_propagator.hpp"
#include "integrators/detail/delegating.hpp"
#include "integrators/detail/lanczos_propagator.hpp"
#include "integrators/detail/one_way_exponential.hpp"
#include "integrators/registry.hpp"
#include "rhs/one_way.hpp"

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

/// Takes the propagator that the scene asks for.
class Exponential final : public DelegatingIntegrator {
 public:
  explicit Exponential(const Options& options)
      : rtol_(options.number("rtol").value_or(1e-8)), basis_(options.word("basis", "chebyshev")) {}

  void prepare(Rhs& rhs, const Plan& plan) override {
    if (!exactly_solvable(rhs))
      throw Refused(
          "the exponential needs constant conductances, sources and fixed values and no radiation; "
          "a potential may drive the temperature, but not the other way round");
    const bool coupled = !rhs.traits().linear;
    if (coupled && basis_ == "lanczos")
      throw Refused("basis=lanczos is for one field; leave it out where a potential drives the temperature");
    if (coupled)
      method_ = std::make_unique<OneWayExponential>(rtol_);
    else if (basis_ == "lanczos")
      method_ = std::make_unique<LanczosPropagator>(rtol_);
    else
      method_ = std::make_unique<ChebyshevPropagator>(rtol_);
    method_->prepare(rhs, plan);
  }

 private:
  double rtol_;
  std::string basis_;
};

}  // namespace

IntegratorEntry exponential_entry() {
  return {
      .name = "exponential",
      .summary =
          "matrix exponential by Chebyshev or Lanczos; exact where coefficients and inputs are constant",
      .source =
          "Tal-Ezer (1986), doi:10.1137/0723001; Hochbruck & Lubich (1997), doi:10.1137/S0036142995280572",
      .order = 0,
      .adaptive = true,
      .keys = exponential_keys(),
      .examples = {"exponential:rtol=1e-13", "exponential:basis=lanczos,rtol=1e-9"},
      .ladder =
          joined({rtol_ladder("exponential", 1, 12), rtol_ladder("exponential:basis=lanczos", 2, 10, 2)}),
      .make = [](const Options& options) { return std::make_unique<Exponential>(options); }};
}

}  // namespace superstep
