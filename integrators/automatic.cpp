/// `auto`: picks the method for a scene and a tolerance, and says why.
///
/// Costs are compared in sweeps over the network; their constants are those of detail/cost_models.hpp.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "integrators/detail/cost_models.hpp"
#include "integrators/detail/exponential/exponential_costs.hpp"
#include "integrators/detail/implicit/shifted_solver.hpp"
#include "integrators/registry.hpp"
#include "rhs/one_way.hpp"

namespace superstep {
namespace {

/// ROCK4, also across the pieces of its inputs. Its error stays below its tolerance in every scene of the
/// corpus.
double sweeps_of_rock(double t_rho, double rtol, double pieces) {
  const double steps = costs::rock_steps * std::pow(1e4 * rtol, -costs::rock_growth) +
                       costs::rock_steps_of_piece * (pieces - 1);
  return costs::rock_finish * steps + std::sqrt(steps * t_rho / costs::rock_interval);
}

/// BDF: steps times the work of a step.
double sweeps_of_cvode(const Rhs& rhs, double t_rho, double rtol) {
  const double steps = costs::bdf_steps * std::pow(rtol, -costs::bdf_growth) *
                       (1 + costs::bdf_decades * std::log10(1 + t_rho));
  const double size = static_cast<double>(rhs.reduction().total()) / costs::usual_size;
  const bool iterative = fastest_linear_solver(rhs) == "pcg";
  return steps *
         (costs::bdf_sweeps + (iterative ? costs::bdf_iterative * std::pow(size, costs::bdf_iterative_growth)
                                         : costs::bdf_direct * std::pow(size, costs::bdf_direct_growth)));
}

/// A method with its parameters and what it would cost.
struct Candidate {
  std::string spec;
  double sweeps = 0;
};

class Automatic final : public Method {
 public:
  explicit Automatic(const Options& options) : rtol_(options.number("rtol")) {}

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
    // A part of the tolerance that keeps the error below all of it.
    const double third = std::max(1e-14, rtol_ / 3), most = std::max(1e-14, rtol_ / 2);
    std::vector<Candidate> candidates;
    const ExponentialWork work = work_of_exponential(rhs, task, rtol_);
    if (exact)
      candidates.push_back({fmt::format("exponential:rtol={:.3g}", rtol_), exponential_costs(work).least()});
    // Where the exponential is exact in one field, nothing explicit is faster.
    if (!exact || !work.one_field)
      candidates.push_back({fmt::format("rock:rtol={:.3g}", most), sweeps_of_rock(t_rho, most, work.pieces)});
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
      .source = "cost models of integrators/detail/cost_models.hpp",
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
