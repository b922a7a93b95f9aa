/// `auto`: picks the method for a scene and a tolerance, and says why.
///
/// By costs that integrators/costs predicts, with constants that `superstep fit` has found.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text/quantity.hpp"
#include "integrators/costs/models.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

class Automatic final : public Method {
 public:
  explicit Automatic(const Options& options) : rtol_(options.number("rtol")) {}

  void prepare(Rhs& rhs, const Task& task) override {
    const auto& [spec, reason] = choose(rhs, task);
    // The same method goes on with what a settled field leaves behind, and knows that it does.
    if (!method_ || spec != spec_) method_ = make_method(spec);
    spec_ = spec;
    own_ = task;  // with the tolerance of the method chosen, which may keep it
    for (double& allowed : own_.allowed) allowed *= method_->rtol() / rtol_;
    method_->prepare(rhs, own_);
    // Of what the exponential says for its basis the name alone: its costs are among those compared here.
    const std::string inner = method_->choice();
    const bool has_basis = spec.starts_with("exponential") && !inner.empty();
    choice_ = spec + (has_basis ? "," + inner.substr(0, inner.find(',')) : "") + reason;
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
  struct Choice {
    std::string spec, reason;
  };
  [[nodiscard]] Choice choose(Rhs& rhs, const Task& task) const {
    const Work work = work_of(rhs, task.t_begin, task.plan->output_times);
    const CostConstants& constants = fitted_constants();
    const auto all = candidates(work, rtol_, constants);
    const std::string spec = spec_of(all.front(), work);
    // The exponential chooses its basis itself; what is compared with is another method.
    const auto other = std::find_if(all.begin(), all.end(), [&](const Candidate& one) {
      return method_of(spec_of(one, work)) != method_of(spec);
    });
    const double sweep = sweep_seconds(work, constants);
    const double own = all.front().seconds / sweep, others = other->seconds / sweep;
    return {spec, fmt::format(" for an error of {:g} of the span is the work of about {}; {} would be {:.0f}",
                              rtol_, quantity(std::lround(own), "sweep"), method_of(spec_of(*other, work)),
                              others)};
  }
  [[nodiscard]] static std::string method_of(const std::string& spec) {
    return spec.substr(0, spec.find(':'));
  }
  [[nodiscard]] static std::string spec_of(const Candidate& candidate, const Work& work) {
    const std::string spec = family_spec(candidate.family, work.physics);
    const bool exponential = method_of(spec) == "exponential", more = !exponential && spec != method_of(spec);
    return fmt::format("{}{}rtol={:.3g}", exponential ? method_of(spec) : spec, more ? "," : ":",
                       candidate.rtol);
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
      .source = "cost models of integrators/costs",
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
