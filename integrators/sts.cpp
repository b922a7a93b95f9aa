/// Super-time-stepping (STS): supersteps of n substeps that are stable as a whole.
/// Source: Alexiades, Amiez & Gremaud (1996); Rojek & Nisar 2026, eqs 22-26.
///
/// `order` says how the substeps are carried out: `recurrence` as the equivalent first-order RKC recurrence
/// and `leja` as reordered Euler steps keep rounding small; `natural` is the published order and loses all
/// digits for large n. Thermoelectric scenes are staggered: see step_halves.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/state_vector.hpp"
#include "integrators/detail/critical_step.hpp"
#include "integrators/detail/run_guard.hpp"
#include "integrators/detail/super_step.hpp"
#include "integrators/detail/superstep_engine.hpp"
#include "integrators/registry.hpp"
#include "rhs/one_way.hpp"

namespace superstep {
namespace {

constexpr int default_substeps = 10;
constexpr double default_damping = 1e-3;
constexpr int most_leja_substeps = 256;
constexpr double default_auto_rtol = 1e-3;

/// Substeps and damping of `n=auto`.
struct AutoSuperstep {
  int n = 1;
  double nu = 0.5;
};

/// A first-order superstep H leaves an error of about 0.1 H/t of the span at time t of a diffusive transient
/// (measured between 0.04 and 0.09 on packings), so that the first output time and the tolerance give H. The
/// damping at the stiff end, 1/cosh(2 n sqrt(nu)), is held at one half, which keeps two thirds of the longest
/// superstep n^2 h_cr.
AutoSuperstep choose_superstep(double wanted, double critical_step) {
  constexpr double exponent = 1.317;   // acosh(2) = 2 n sqrt(nu)
  constexpr double part_kept = 0.658;  // tanh(exponent)/exponent
  constexpr double most = 10'000;
  AutoSuperstep out;
  out.n =
      static_cast<int>(std::clamp(std::floor(std::sqrt(wanted / (part_kept * critical_step))), 1.0, most));
  out.nu = std::min(0.5, exponent * exponent / (4.0 * out.n * out.n));
  return out;
}

class SuperTimeStepping final : public Integrator {
 public:
  explicit SuperTimeStepping(const Options& options)
      : critical_step_(options),
        n_(options.integer("n").value_or(default_substeps)),
        nu_(options.number("nu").value_or(default_damping)),
        order_(options.word("order", "")),
        automatic_(options.word("n", "") == "auto"),
        rtol_(options.number("rtol").value_or(default_auto_rtol)) {
    if (!automatic_ && options.has("rtol"))
      throw UsageError("sts: rtol goes with n=auto; leave it out, or choose that");
    if (automatic_ && options.has("nu")) throw UsageError("sts: n=auto chooses nu as well; leave nu out");
  }

  void prepare(Rhs& rhs, const Plan& plan) override {
    rhs_ = &rhs;
    track_inflow_ = plan.track_inflow;
    guard_.prepare(rhs, plan);
    recorder_.prepare(plan);
    state_.resize(rhs.size());
    if (automatic_) {
      const double critical_step = critical_step_.resolve(rhs, plan.t_begin, state_);
      const double first_output = plan.output_times.front() - plan.t_begin;
      const auto chosen = choose_superstep(10 * rtol_ * first_output, critical_step);
      n_ = chosen.n;
      nu_ = chosen.nu;
    }
    halves_ = rhs.one_way();
    plan_ = SuperstepPlan::make(n_, nu_, order_.empty() ? default_order() : order_);
    if (!halves_) return whole_.prepare(rhs);
    driver_.prepare(halves_->driver());
    driven_.prepare(halves_->driven());
    rate_.resize(halves_->driven().size());
  }

  void start(double t, std::span<const double> y) override {
    t_ = t;
    rhs_->restart(t);
    state_.assign(y.begin(), y.end());
    if (halves_) {
      driver_.start(y.first(halves_->driver().size()));
      driven_.start(y.subspan(halves_->driver().size()));
    } else {
      whole_.start(y);
    }
    superstep_ = critical_step_.resolve(*rhs_, t, state()) * superstep_length(n_, nu_);
    statistics_ = {.max_stages = n_, .time_per_sweep = superstep_ / n_};
  }

  Outcome advance(double t_out) override {
    double t_in = t_;
    auto steps = steps_to_cover(t_out - t_in, superstep_);
    const std::uint64_t supersteps_per_check = 1 + RunGuard::stride / static_cast<unsigned>(n_);
    for (std::uint64_t k = 1; k <= steps; ++k) {
      // The last superstep before an output time keeps n and scales all substeps.
      take_superstep(k == steps ? t_out : t_in + static_cast<double>(k) * superstep_);
      if (guard_.stop_requested(t_)) return interrupted_at(t_);
      if (k % supersteps_per_check != 0) continue;
      if (Outcome outcome = guard_.check(t_, state()); !outcome.ok()) return outcome;
      if (!critical_step_.may_have_changed(*rhs_, t_, state())) continue;
      superstep_ = critical_step_.resolve(*rhs_, t_, state()) * superstep_length(n_, nu_);
      t_in = t_;
      steps = steps_to_cover(t_out - t_in, superstep_);
      k = 0;
    }
    return guard_.check(t_, state());
  }

  [[nodiscard]] double time() const noexcept override { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept override {
    return halves_ ? std::span<const double>(state_) : whole_.state();
  }
  [[nodiscard]] const Statistics& statistics() const noexcept override { return statistics_; }
  [[nodiscard]] std::string choice() const override {
    if (!automatic_) return {};
    return fmt::format(
        "n = {}, nu = {:.3g}: superstep {:.3g} s for a tolerance of {:.1g} at the first output time", n_, nu_,
        superstep_, rtol_);
  }

 private:
  /// Leja substeps cost exactly a forward Euler step each; the recurrence is for numbers beyond practice, and
  /// for two fields that act on each other within a superstep: its stages mean something.
  [[nodiscard]] std::string default_order() const {
    const bool coupled = rhs_->fields().size() > 1 && !halves_ && !rhs_->traits().linear;
    return n_ <= most_leja_substeps && !coupled ? "leja" : "recurrence";
  }

  void take_superstep(double t_next) {
    const double h = t_next - t_;
    double* inflow = track_inflow_ ? &statistics_.inflow : nullptr;
    if (halves_) {
      step_halves(h, inflow);
    } else {
      whole_.step(plan_, t_, h, inflow);
    }
    t_ = t_next;
    ++statistics_.steps;
    recorder_.record(t_, state());
  }

  /// Staggered, one common superstep: first the potential, then the temperature with the heat of the
  /// potentials at the superstep's end. Source: Rojek & Nisar 2026, section 7.
  void step_halves(double h, double* inflow) {
    if (rhs_->steps(0)) {
      driver_.step(plan_, t_, h, nullptr);
      halves_->rate(t_ + h, driver_.state(), rate_);
    }
    halves_->drive(rate_);
    driven_.step(plan_, t_, h, inflow);
    halves_->drive({});
    std::copy(driver_.state().begin(), driver_.state().end(), state_.begin());
    std::copy(driven_.state().begin(), driven_.state().end(),
              state_.begin() + static_cast<std::ptrdiff_t>(driver_.state().size()));
  }

  CriticalStep critical_step_;
  int n_;
  double nu_;
  std::string order_;
  bool automatic_;
  double rtol_;
  Rhs* rhs_ = nullptr;
  RunGuard guard_;
  ProbeRecorder recorder_;
  SuperstepPlan plan_;
  OneWayCoupling* halves_ = nullptr;  ///< null: the state is stepped as a whole
  SuperstepEngine whole_, driver_, driven_;
  StateVector state_, rate_;
  double t_ = 0, superstep_ = 0;
  bool track_inflow_ = false;
  Statistics statistics_;
};

std::vector<OptionKey> sts_keys() {
  std::vector<OptionKey> keys = {
      {.name = "n",
       .type = OptionKey::Type::integer,
       .min = 1,
       .max = 10000,
       .words = {"auto"},
       .fallback = "10",
       .meaning = "substeps in a superstep; auto chooses n and nu from the spectrum and rtol"},
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
  keys.push_back({.name = "rtol",
                  .min = 1e-14,
                  .max = 0.5,
                  .fallback = "1e-3",
                  .meaning = "with n=auto: error wanted at output times, relative to the span"});
  for (auto& key : critical_step_keys()) keys.push_back(std::move(key));
  return keys;
}

}  // namespace

IntegratorEntry sts_entry() {
  return {.name = "sts",
          .summary = "super-time-stepping: n substeps, stable as a whole",
          .source = "Alexiades, Amiez & Gremaud (1996); Rojek & Nisar 2026, eqs 22-26",
          .order = 1,
          .adaptive = false,
          .keys = sts_keys(),
          .examples = {"sts:n=5,nu=1e-2,order=recurrence", "sts:n=5,nu=0.05,order=natural",
                       "sts:n=20,nu=1e-3", "sts:n=auto,rtol=1e-2"},
          .ladder = {"sts:n=10,nu=0.05,alpha=1", "sts:n=5,nu=1e-2", "sts:n=10,nu=1e-2", "sts:n=20,nu=1e-3",
                     "sts:n=40,nu=1e-3", "sts:n=auto,rtol=1e-2", "sts:n=auto,rtol=1e-3"},
          .make = [](const Options& options) { return std::make_unique<SuperTimeStepping>(options); }};
}

}  // namespace superstep
