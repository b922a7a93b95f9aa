/// Exponential integration of linear networks: exact up to the tolerance, in one go for all output times
/// between two breakpoints of the inputs. Chebyshev: Tal-Ezer (1986), doi:10.1137/0723001. Lanczos: Hochbruck
/// & Lubich (1997), doi:10.1137/S0036142995280572.

#include <utility>

#include "integrators/detail/exponential/chebyshev_propagator.hpp"
#include "integrators/detail/exponential/lanczos_propagator.hpp"
#include "integrators/detail/exponential/one_way_exponential.hpp"
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
class Exponential final : public Method {
 public:
  explicit Exponential(const Options& options)
      : rtol_(options.number("rtol").value_or(1e-8)), basis_(options.word("basis", "chebyshev")) {}

  void prepare(Rhs& rhs, const Task& task) override {
    if (!exactly_solvable(rhs))
      throw Refused(
          "the exponential needs constant conductances and no radiation; a potential may drive the "
          "temperature, but not the other way round");
    const bool coupled = !rhs.traits().linear;
    if (coupled && basis_ == "lanczos")
      throw Refused("basis=lanczos is for one field; leave it out where a potential drives the temperature");
    const bool rest = std::exchange(coupled_, coupled) && !coupled;
    if (coupled)
      method_ = std::make_unique<OneWayExponential>(rtol_);
    else if (basis_ == "lanczos" || (rest && rhs.traits().autonomous))
      method_ = std::make_unique<LanczosPropagator>(rtol_, rest ? part_for_rest : 1);
    else
      method_ = std::make_unique<ChebyshevPropagator>(rtol_);
    method_->prepare(rhs, task);
  }
  [[nodiscard]] double rtol() const override { return rtol_; }
  [[nodiscard]] Propagator* propagator() override { return method_.get(); }
  void reset_counts() override {
    if (method_) method_->reset_counts();
  }
  void add_counts(Statistics& statistics) const override {
    if (method_) method_->add_counts(statistics);
  }

 private:
  /// Once the potential has settled the temperature is smooth, and Lanczos is fast. It keeps the heat of an
  /// insulated network to its tolerance only: three digits more cost a few vectors.
  static constexpr double part_for_rest = 2.5e-4;

  double rtol_;
  std::string basis_;
  bool coupled_ = false;
  std::unique_ptr<Propagator> method_;
};

}  // namespace

IntegratorEntry exponential_entry() {
  return {
      .name = "exponential",
      .summary =
          "matrix exponential by Chebyshev or Lanczos; exact where coefficients are constant and inputs "
          "linear in time",
      .source =
          "Tal-Ezer (1986), doi:10.1137/0723001; Hochbruck & Lubich (1997), doi:10.1137/S0036142995280572",
      .colour = "#3fb8f0",
      .order = 0,
      .adaptive = true,
      .keys = exponential_keys(),
      .examples = {"exponential:rtol=1e-13", "exponential:basis=lanczos,rtol=1e-9"},
      .ladder =
          joined({rtol_ladder("exponential", 1, 12), rtol_ladder("exponential:basis=lanczos", 2, 10, 2)}),
      .make = [](const Options& options) { return std::make_unique<Exponential>(options); }};
}

}  // namespace superstep
