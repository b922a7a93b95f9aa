/// Exponential integration of linear networks: exact up to the tolerance, in one go for all output times
/// between two breakpoints of the inputs. Chebyshev: Tal-Ezer (1986), doi:10.1137/0723001. Lanczos: Hochbruck
/// & Lubich (1997), doi:10.1137/S0036142995280572. Shift-and-invert: van den Eshof & Hochbruck (2006),
/// doi:10.1137/040605461.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "integrators/detail/exponential/basis_choice.hpp"
#include "integrators/detail/exponential/chebyshev_propagator.hpp"
#include "integrators/detail/exponential/driven_lanczos_propagator.hpp"
#include "integrators/detail/exponential/lanczos_propagator.hpp"
#include "integrators/detail/exponential/one_way_exponential.hpp"
#include "integrators/detail/exponential/shift_invert_propagator.hpp"
#include "integrators/registry.hpp"
#include "rhs/one_way.hpp"

namespace superstep {
namespace {

constexpr double mebibyte = 0x1p20;

std::vector<OptionKey> exponential_keys() {
  return {
      {.name = "rtol",
       .min = 1e-16,
       .max = 0.5,
       .fallback = "1e-8",
       .meaning = "error allowed at every output time (rms), relative to the span of the field"},
      {.name = "basis",
       .type = OptionKey::Type::word,
       .words = {"auto", "chebyshev", "lanczos", "shift-invert"},
       .fallback = "auto",
       .meaning = "chebyshev: known beforehand, any input; lanczos: fits the start; shift-invert: one "
                  "factorization, however stiff; auto: by predicted cost"},
      {.name = "memory",
       .min = 1,
       .max = 1e7,
       .unit = "MiB",
       .fallback = fmt::format("{}", default_memory / mebibyte),
       .meaning = "what the basis of lanczos may take; beyond it a new one is begun on the way"},
  };
}

/// Takes the propagator that the scene asks for.
class Exponential final : public Method {
 public:
  explicit Exponential(const Options& options)
      : rtol_(options.number("rtol")),
        memory_(options.number("memory") * mebibyte),
        basis_(options.word("basis")) {}

  void prepare(Rhs& rhs, const Task& task) override {
    if (!exactly_solvable(rhs))
      throw Refused(
          "the exponential needs constant conductances and no radiation; a potential may drive the "
          "temperature, but not the other way round, and a steady one only where its inputs do not change in "
          "time");
    const bool coupled = rhs.fields().size() > 1;
    const bool rest = std::exchange(coupled_, coupled) && !coupled;
    choice_.clear();
    if (coupled) {
      if (basis_ == "lanczos" || basis_ == "shift-invert")
        throw Refused("basis=" + basis_ +
                      " is for one field; leave it out where there are a potential and a temperature");
      method_ = std::make_unique<OneWayExponential>(rtol_);
    } else {
      const std::string basis = basis_ == "auto" ? choose(rhs, task) : basis_;
      const double part = rest ? part_for_rest : 1;
      if (basis == "lanczos" && !rhs.traits().autonomous)
        method_ = std::make_unique<DrivenLanczosPropagator>(rtol_, memory_, part);
      else if (basis == "lanczos")
        method_ = std::make_unique<LanczosPropagator>(rtol_, memory_, part);
      else if (basis == "shift-invert")
        method_ = std::make_unique<ShiftInvertPropagator>(rtol_, part);
      else
        method_ = std::make_unique<ChebyshevPropagator>(rtol_);
    }
    method_->prepare(rhs, task);
  }
  [[nodiscard]] double rtol() const override { return rtol_; }
  [[nodiscard]] Propagator* propagator() override { return method_.get(); }
  [[nodiscard]] std::string choice() const override { return choice_; }
  void reset_counts() override {
    if (method_) method_->reset_counts();
  }
  void add_counts(Statistics& statistics) const override {
    if (method_) method_->add_counts(statistics);
  }

 private:
  std::string choose(Rhs& rhs, const Task& task) {
    auto [basis, reason] = choose_basis(work_of(rhs, task.t_begin, task.plan->output_times, memory_), rtol_);
    choice_ = "basis=" + reason;
    return basis;
  }

  /// Lanczos and shift-and-invert keep the heat of an insulated network to their tolerance only, where the
  /// heat of a settled potential goes into it: three digits more cost a few vectors.
  static constexpr double part_for_rest = 2.5e-4;

  double rtol_, memory_;
  std::string basis_, choice_;
  bool coupled_ = false;
  std::unique_ptr<Propagator> method_;
};

}  // namespace

IntegratorEntry exponential_entry() {
  return {
      .name = "exponential",
      .summary =
          "matrix exponential by Lanczos, Chebyshev or shift-and-invert; exact where coefficients are "
          "constant and inputs linear in time",
      .source =
          "Tal-Ezer (1986), doi:10.1137/0723001; Hochbruck & Lubich (1997), doi:10.1137/S0036142995280572; "
          "van den Eshof & Hochbruck (2006), doi:10.1137/040605461",
      .colour = "#3fb8f0",
      .order = 0,
      .adaptive = true,
      .distributed = Distributed::exact,
      .gathered_where = "with basis=shift-invert",
      .keys = exponential_keys(),
      .examples = {"exponential:basis=chebyshev,rtol=1e-13", "exponential:basis=lanczos,rtol=1e-9",

                   "exponential:basis=shift-invert,rtol=1e-8"},
      .ladder =
          joined({rtol_ladder("exponential", 1, 12), rtol_ladder("exponential:basis=chebyshev", 2, 12, 2),
                  rtol_ladder("exponential:basis=lanczos", 2, 10, 2),
                  rtol_ladder("exponential:basis=shift-invert", 2, 8, 2)}),
      .make = [](const Options& options) { return std::make_unique<Exponential>(options); }};
}

}  // namespace superstep
