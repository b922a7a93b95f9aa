/// `auto`: picks the method for a scene and a tolerance, and says why.
///
/// Costs are compared in sweeps over the network, from measurements on packings: see cost_of_* below.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "integrators/detail/exponential/exponential_costs.hpp"
#include "integrators/detail/implicit/shifted_solver.hpp"
#include "integrators/registry.hpp"
#include "rhs/one_way.hpp"

namespace superstep {
namespace {

constexpr double default_rtol = 1e-4;

// Constants fitted to reports/records/work_precision_nial_thermal.csv: 16 538 unknowns, t rho = 5.8e4 with
// the certified rho.

/// RKC2 on a transient (1029 to 7660 sweeps for rtol 1e-3 to 1e-8, within 7 %).
double sweeps_of_rkc(double t_rho, double rtol) {
  return 1.17 * std::sqrt(t_rho) * std::pow(rtol, -0.176) + 40;
}

/// ROCK4 on a transient (1846, 2694, 4891 sweeps for rtol 1e-4, 1e-6, 1e-8); its global error stays below
/// rtol.
double sweeps_of_rock(double t_rho, double rtol) {
  return 2.9 * std::sqrt(t_rho) * std::pow(rtol, -0.106) + 40;
}

/// BDF, in sweeps: steps, weakly growing with accuracy and with the decades between the fastest and the
/// slowest scale (91, 167, 329 for rtol 1e-4, 1e-6, 1e-8), times a step's work. At rtol = 1e-6 that was 115
/// sweeps with conjugate gradients, growing as n^0.43 (110 at 9 680, 210 at 93 104, 650 at 980 000 unknowns),
/// and 315 with a factorization, growing with the fill of a three-dimensional network, n^(2/3).
double sweeps_of_cvode(const Rhs& rhs, double t_rho, double rtol) {
  const double steps = 25 * std::pow(rtol, -0.125) * (1 + std::log10(1 + t_rho) / 10);
  const double size = static_cast<double>(rhs.reduction().total()) / 16'538;
  const bool iterative = fastest_linear_solver(rhs) == "pcg";
  return steps * (2 + (iterative ? 115 * std::pow(size, 0.43) : 315 * std::pow(size, 2.0 / 3.0)));
}

/// A method with its parameters and what it would cost.
struct Candidate {
  std::string spec;
  double sweeps = 0;
};

class Automatic final : public Method {
 public:
  explicit Automatic(const Options& options) : rtol_(options.number("rtol").value_or(default_rtol)) {}

  void prepare(Rhs& rhs, const Task& task) override {
    const std::string spec = choose(rhs, task);
    // The same method goes on with what a settled field leaves behind, and knows that it does.
    if (!method_ || spec != spec_) method_ = make_method(spec);
    spec_ = spec;
    own_ = task;  // with the tolerance of the method chosen, which may keep it
    for (double& allowed : own_.allowed) allowed *= method_->rtol() / rtol_;
    method_->prepare(rhs, own_);
    if (const std::string inner = method_->choice(); spec.starts_with("exponential") && !inner.empty())
      choice_ += "; " + inner;
  }
  [[nodiscard]] double rtol() const override { return rtol_; }
  [[nodiscard]] OneStepMethod* one_step() override { return method_->one_step(); }
  [[nodiscard]] Propagator* propagator() override { return method_->propagator(); }
  void reset_counts() override {
    if (method_) method_->reset_counts();
  }
  void add_counts(Statistics& statistics) const override {
    if (method_) method_->add_counts(statistics);
  }
  [[nodiscard]] std::string choice() const override { return choice_; }

 private:
  std::string choose(Rhs& rhs, const Task& task) {
    const std::vector<double> zero(rhs.size(), 0.0);
    const double t_rho = (task.t_end - task.t_begin) * rhs.spectral_bound(task.t_begin, zero);
    const bool exact = exactly_solvable(rhs);
    const double third = std::max(1e-14, rtol_ / 3);
    std::vector<Candidate> candidates;
    if (exact) {
      const auto costs = exponential_costs(work_of_exponential(rhs, task, rtol_));
      candidates.push_back({fmt::format("exponential:rtol={:.3g}", rtol_), costs.least()});
    } else {
      candidates.push_back({fmt::format("rkc:rtol={:.3g}", third), sweeps_of_rkc(t_rho, third)});
      candidates.push_back({fmt::format("rock:rtol={:.3g}", third), sweeps_of_rock(t_rho, third)});
    }
    const auto cheaper = [](const Candidate& a, const Candidate& b) { return a.sweeps < b.sweeps; };
    const auto best = std::min_element(candidates.begin(), candidates.end(), cheaper);
    const double explicit_cost = best->sweeps, implicit_cost = sweeps_of_cvode(rhs, t_rho, third);
    const std::string spec =
        implicit_cost < explicit_cost ? fmt::format("cvode:rtol={:.3g}", third) : best->spec;
    const bool implicit = implicit_cost < explicit_cost;
    choice_ = fmt::format(
        "{}, because it costs about {:.0f} sweeps over the network; {} would cost the work of {:.0f}", spec,
        implicit ? implicit_cost : explicit_cost, implicit ? best->spec : "cvode",
        implicit ? explicit_cost : implicit_cost);
    return spec;
  }

  double rtol_;
  std::string spec_, choice_;
  Task own_;
  std::unique_ptr<Method> method_;
};

}  // namespace

IntegratorEntry automatic_entry() {
  return {
      .name = "auto",
      .summary = "picks method and parameters from spectrum, linearity, size and tolerance, and says why",
      .source = "cost models measured on packings, integrators/automatic.cpp",
      .colour = "#9a9a2e",
      .order = 0,
      .adaptive = true,
      .distributed = Distributed::exact,
      .gathered_where = "where it chooses such a method",
      .keys = {{.name = "rtol",
                .min = 1e-12,
                .max = 0.5,
                .fallback = "1e-4",
                .meaning = "error allowed at every output time (rms), relative to the span of the field"}},
      .examples = {"auto:rtol=1e-6"},
      .ladder = rtol_ladder("auto", 2, 10, 2),
      .make = [](const Options& options) { return std::make_unique<Automatic>(options); }};
}

}  // namespace superstep
