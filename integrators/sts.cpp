/// Super-time-stepping (STS): supersteps of n substeps that are stable as a whole.
/// Source: Alexiades, Amiez & Gremaud (1996); Rojek & Nisar 2026, eqs 22-26.
///
/// `order` says how the substeps are carried out: `recurrence` as the equivalent first-order RKC recurrence
/// and `leja` as reordered Euler steps keep rounding small; `natural` is the published order and loses all
/// digits for large n.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "integrators/detail/critical_step.hpp"
#include "integrators/detail/run_guard.hpp"
#include "integrators/detail/super_step.hpp"
#include "integrators/detail/three_term.hpp"
#include "integrators/registry.hpp"

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
    engine_.resize(rhs.size());
    if (automatic_) {
      const double critical_step = critical_step_.resolve(rhs, plan.t_begin, state_);
      const double first_output = plan.output_times.front() - plan.t_begin;
      const auto chosen = choose_superstep(10 * rtol_ * first_output, critical_step);
      n_ = chosen.n;
      nu_ = chosen.nu;
    }
    // Leja substeps cost exactly a forward Euler step each; the recurrence is for numbers beyond practice.
    if (order_.empty()) order_ = n_ <= most_leja_substeps ? "leja" : "recurrence";
    if (order_ == "recurrence") {
      first_order_chebyshev(n_, 2 * nu_ / (1 - nu_), scheme_);
    } else {
      substeps_ = superstep_substeps(n_, nu_);
      if (order_ == "leja") substeps_ = leja_ordered(std::move(substeps_));
    }
  }

  void start(double t, std::span<const double> y) override {
    t_ = t;
    state_.assign(y.begin(), y.end());
    superstep_ = critical_step_.resolve(*rhs_, t, state_) * superstep_length(n_, nu_);
    statistics_ = {.max_stages = n_, .time_per_sweep = superstep_ / n_};
  }

  Outcome advance(double t_out) override {
    const double t_in = t_;
    const auto steps = steps_to_cover(t_out - t_in, superstep_);
    const std::uint64_t supersteps_per_check = 1 + RunGuard::stride / static_cast<unsigned>(n_);
    for (std::uint64_t k = 1; k <= steps; ++k) {
      // The last superstep before an output time keeps n and scales all substeps.
      take_superstep(k == steps ? t_out : t_in + static_cast<double>(k) * superstep_);
      if (guard_.stop_requested(t_)) return interrupted_at(t_);
      if (k % supersteps_per_check != 0) continue;
      if (Outcome outcome = guard_.check(t_, state_); !outcome.ok()) return outcome;
    }
    return guard_.check(t_, state_);
  }

  [[nodiscard]] double time() const noexcept override { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept override { return state_; }
  [[nodiscard]] const Statistics& statistics() const noexcept override { return statistics_; }
  [[nodiscard]] std::string choice() const override {
    if (!automatic_) return {};
    return fmt::format(
        "n = {}, nu = {:.3g}: superstep {:.3g} s for a tolerance of {:.1g} at the first output time", n_, nu_,
        superstep_, rtol_);
  }

 private:
  void take_superstep(double t_next) {
    const double h = t_next - t_;
    if (order_ == "recurrence") {
      engine_.step(*rhs_, scheme_, t_, h, state_, {}, track_inflow_ ? &statistics_.inflow : nullptr);
      std::swap(state_, engine_.result());
    } else {
      euler_substeps(h / superstep_length(n_, nu_));
    }
    t_ = t_next;
    ++statistics_.steps;
    recorder_.record(t_, state_);
  }

  void euler_substeps(double critical_step) {
    double t = t_;
    for (const double substep : substeps_) {
      const double tau = substep * critical_step;
      if (track_inflow_) statistics_.inflow += tau * rhs_->inflow(t, state_);
      rhs_->stage(t, {.y1 = state_.data(), .a = 1, .d = tau}, engine_.result());
      std::swap(state_, engine_.result());
      t += tau;
    }
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
  ThreeTermScheme scheme_;
  ThreeTermEngine engine_;
  std::vector<double> substeps_, state_;
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
