/// Super-time-stepping (STS): supersteps of n substeps that are stable as a whole.
/// Source: Alexiades, Amiez & Gremaud (1996); Rojek & Nisar 2026, eqs 22-26.
///
/// `order` says how the substeps are carried out: `recurrence` as the equivalent first-order RKC recurrence
/// and `leja` as reordered Euler steps keep rounding small; `natural` is the published order and loses all
/// digits for large n. Thermoelectric scenes are staggered: see step_halves.
///
/// `n=auto` is the same polynomial under error control: supersteps as long as the tolerance allows, whatever
/// the inputs do, and as many substeps as each of them needs.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/error.hpp"
#include "core/state_vector.hpp"
#include "integrators/detail/explicit/critical_step.hpp"
#include "integrators/detail/explicit/stabilised.hpp"
#include "integrators/detail/explicit/superstep_engine.hpp"
#include "integrators/registry.hpp"
#include "integrators/schemes/super_step.hpp"
#include "rhs/one_way.hpp"

namespace superstep {
namespace {

constexpr int most_leja_substeps = 256;
constexpr int most_substeps = 10'000;

/// Supersteps of `n=auto`: as long as the error allows, n as stability then asks. The damping at the stiff
/// end, 1/cosh(2 n sqrt(nu)), is held at one half, which keeps two thirds of the longest superstep n^2 h_cr.
double automatic_damping(int n) {
  constexpr double exponent = 1.317;  // acosh(2) = 2 n sqrt(nu)
  return std::min(0.5, exponent * exponent / (4.0 * n * n));
}

void build_automatic(int n, ThreeTermScheme& scheme) {
  const double nu = automatic_damping(n);
  first_order_chebyshev(n, 2 * nu / (1 - nu), scheme);
}

double automatic_beta(int n) {
  constexpr double critical = 2;  // h lambda of forward Euler
  return critical * superstep_length(n, automatic_damping(n));
}

const StabilisedFamily& automatic_family() {
  static const StabilisedFamily family{.name = "sts",
                                       .order = 1,
                                       .fewest_stages = 1,
                                       .stage_step = 1,
                                       .beta = automatic_beta,
                                       .build = build_automatic,
                                       .most_stages = most_substeps};
  return family;
}

bool is_automatic(const Options& options) {
  return options.word("n") == "auto";
}

class SuperTimeStepping final : public OneStepMethod {
 public:
  explicit SuperTimeStepping(const Options& options)
      : critical_step_(options),
        n_(options.integer("n")),
        nu_(options.number("nu")),
        order_(options.has("order") ? options.word("order") : ""),
        mean_heat_(options.word("heat") == "mean") {
    if (options.has("rtol")) throw UsageError("sts: rtol goes with n=auto; leave it out, or choose that");
  }

  void prepare(Rhs& rhs, const Task& task) override {
    rhs_ = &rhs;
    critical_step_.prepare(rhs, task.spans);
    halves_ = rhs.one_way();
    plan_ = SuperstepPlan::make(n_, nu_, order_.empty() ? default_order() : order_);
    if (!halves_) return whole_.prepare(rhs);
    driver_.prepare(halves_->driver());
    driven_.prepare(halves_->driven());
    for (auto* v : {&driven_state_, &rate_, &rate_before_}) v->resize(halves_->driven().size());
    driver_state_.resize(halves_->driver().size());
  }

  [[nodiscard]] Pace pace() const override { return Pace::multiples; }
  [[nodiscard]] double own_step(double t, std::span<const double> y) override {
    return critical_step_.at(t, y) * superstep_length(n_, nu_);
  }
  [[nodiscard]] bool stability_varies() const override { return critical_step_.varies(); }
  [[nodiscard]] double stable_step(double t, std::span<const double> y) override {
    return critical_step_.limit(t, y) * superstep_length(n_, nu_);
  }
  void restart(double t, std::span<const double> y, bool /*smooth*/) override {
    if (superstep_ == 0) superstep_ = own_step(t, y);
  }

  /// The last superstep before a landing keeps n and scales all substeps.
  Trial attempt(const Step& step, StateVector& state, StateVector& next) override {
    next = state;  // same size: no allocation
    if (halves_)
      step_halves(step, next);
    else
      whole_.step(plan_, step.t, step.h(), next);
    return {};
  }

  void reset_counts() override { superstep_ = 0; }
  void add_counts(Statistics& statistics) const override {
    statistics.max_stages = std::max(statistics.max_stages, n_);
    if (statistics.time_per_sweep == 0) statistics.time_per_sweep = superstep_ / n_;
  }

 private:
  /// Leja substeps cost exactly a forward Euler step each; the recurrence is for numbers beyond practice, and
  /// for two fields that act on each other within a superstep: its stages mean something.
  [[nodiscard]] std::string default_order() const {
    const bool coupled = rhs_->fields().size() > 1 && !halves_ && !rhs_->traits().linear;
    return n_ <= most_leja_substeps && !coupled ? "leja" : "recurrence";
  }

  /// Staggered, one common superstep: first the potential, then the temperature with the heat of the
  /// potentials at the superstep's end (Rojek & Nisar 2026, section 7), or with the mean of both ends, which
  /// is of second order in the superstep.
  void step_halves(const Step& step, StateVector& y) {
    const auto middle = y.begin() + static_cast<std::ptrdiff_t>(driver_state_.size());
    std::copy(y.begin(), middle, driver_state_.begin());
    std::copy(middle, y.end(), driven_state_.begin());
    if (mean_heat_) halves_->rate(step.t, driver_state_, rate_before_);
    driver_.step(plan_, step.t, step.h(), driver_state_);
    halves_->rate(step.ends.front(), driver_state_, rate_);
    if (mean_heat_)
      for_each_entry(rate_.size(), [&](std::size_t i) { rate_[i] = 0.5 * (rate_before_[i] + rate_[i]); });
    halves_->drive(rate_);
    driven_.step(plan_, step.t, step.h(), driven_state_);
    halves_->drive({});
    std::copy(driver_state_.begin(), driver_state_.end(), y.begin());
    std::copy(driven_state_.begin(), driven_state_.end(), middle);
  }

  CriticalStep critical_step_;
  int n_;
  double nu_;
  std::string order_;
  bool mean_heat_;
  Rhs* rhs_ = nullptr;
  SuperstepPlan plan_;
  OneWayCoupling* halves_ = nullptr;  ///< null: the state is stepped as a whole
  SuperstepEngine whole_, driver_, driven_;
  StateVector driver_state_, driven_state_, rate_, rate_before_;
  double superstep_ = 0;  ///< the first one [s]
};

std::unique_ptr<Method> make_sts(const Options& options) {
  if (!is_automatic(options)) return std::make_unique<SuperTimeStepping>(options);
  for (const char* key : {"nu", "order", "heat", "step", "alpha", "fraction", "bound"})
    if (options.has(key))
      throw UsageError(
          fmt::format("sts: n=auto chooses supersteps and damping by itself; leave {} out", key));
  return std::make_unique<Stabilised>(automatic_family(), options);
}

std::vector<OptionKey> sts_keys() {
  std::vector<OptionKey> keys = {
      {.name = "n",
       .type = OptionKey::Type::integer,
       .min = 1,
       .max = most_substeps,
       .words = {"auto"},
       .fallback = "10",
       .meaning = "substeps in a superstep; auto: supersteps as long as rtol allows, n and nu follow"},
      {.name = "nu",
       .min = 0,
       .max = 1,
       .min_open = true,
       .max_open = true,
       .fallback = "1e-3",
       .meaning = "damping; smaller is longer and less damped"},
      {.name = "order",
       .type = OptionKey::Type::word,
       .words = {"recurrence", "leja", "natural"},
       .fallback = "leja up to 256 substeps, then recurrence",
       .meaning = "how substeps are carried out; natural loses digits for large n"},
  };
  keys.push_back({.name = "heat",
                  .type = OptionKey::Type::word,
                  .words = {"end", "mean"},
                  .fallback = "end",
                  .meaning = "where a potential heats and nothing acts back: the heat of a superstep, of the "
                             "potentials at its end as the paper has it, or the mean of both ends"});
  keys.push_back(
      {.name = "rtol",
       .min = 1e-14,
       .max = 0.5,
       .fallback = "1e-4",
       .meaning =
           "with n=auto: error allowed at every output time (rms), relative to the span of the field"});
  for (auto& key : critical_step_keys()) keys.push_back(std::move(key));
  return keys;
}

StabilityModel stability_model(SuperstepShape shape, const std::string& order) {
  const int n = shape.n;  // not a structured binding: clang 14 cannot capture one
  const double nu = shape.nu;
  const double length = superstep_length(n, nu);
  return {.family = "sts",
          .parameters = fmt::format("n={},nu={:g}", n, nu),
          .order = order,
          .stages = n,
          .beta = 2 * length,
          .z_stiff = stability_margin * 2 * length,
          .response = [=](double z) { return static_cast<double>(superstep_response(n, nu, z / length)); },
          .spec =
              [=](double step) {
                return fmt::format("sts:n={},nu={},order={},step={:.17g}", n, nu, order, step / length);
              }};
}

std::vector<StabilityModel> superstep_stability(bool quick) {
  std::vector<StabilityModel> models;
  for (const auto& shape : superstep_shapes(quick))
    for (const char* order : superstep_orders) models.push_back(stability_model(shape, order));
  return models;
}

std::vector<StabilityModel> stability_limits(bool quick) {
  std::vector<StabilityModel> models = {stability_model({10, 1e-3}, "leja")};
  if (!quick) models.push_back(stability_model({20, 1e-4}, "leja"));
  return models;
}

}  // namespace

IntegratorEntry sts_entry() {
  return {.name = "sts",
          .summary = "super-time-stepping: n substeps, stable as a whole",
          .source = "Alexiades, Amiez & Gremaud (1996); Rojek & Nisar 2026, eqs 22-26",
          .colour = "#0f7dc2",
          .order = 1,
          .adaptive = false,
          .distributed = Distributed::exact,
          .keys = sts_keys(),
          .examples = {"sts:n=5,nu=1e-2,order=recurrence", "sts:n=5,nu=0.05,order=natural",
                       "sts:n=20,nu=1e-3", "sts:n=auto,rtol=1e-2"},
          .representatives = {"sts:n=10,nu=1e-3", "sts:n=20,nu=1e-4", "sts:n=25,nu=1e-5"},
          .ladder = {"sts:n=10,nu=0.05,alpha=1", "sts:n=5,nu=1e-2", "sts:n=10,nu=1e-2", "sts:n=20,nu=1e-3",
                     "sts:n=40,nu=1e-3", "sts:n=auto,rtol=1e-2", "sts:n=auto,rtol=1e-3"},
          .stability = {.functions = superstep_stability, .limits = stability_limits},
          .make = make_sts};
}

}  // namespace superstep
