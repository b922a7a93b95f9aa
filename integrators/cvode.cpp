/// CVODE's variable-order BDF; with a sparse direct solver the reference of the harness.
/// Source: Hindmarsh et al. (2005), SUNDIALS, doi:10.1145/1089014.1089020; KLU: Davis & Palamadai Natarajan
/// (2010), doi:10.1145/1824801.1824814.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "integrators/detail/implicit/sundials_propagator.hpp"
#include "integrators/detail/tolerance.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

class CvodeBdf final : public SundialsPropagator {
 public:
  explicit CvodeBdf(const Options& options)
      : SundialsPropagator(options.number("rtol"),
                           options.has("ordering") && !options.has("linsol") ? "klu" : options.word("linsol"),
                           options.word("ordering")),
        atol_(options.given("atol")),
        local_(options.word("tolerance") == "local") {
    if (options.has("ordering") && linsol_ != "klu")
      throw UsageError("cvode: ordering goes with linsol=klu; leave it out, or choose that");
    if (atol_ && !local_)
      throw UsageError("cvode: atol goes with tolerance=local; leave it out, or choose that");
  }

  void prepare(Rhs& rhs, const Task& task) override;
  void begin(double t, double end, std::span<const double> y, std::span<const Instant> instants,
             bool smooth) override;
  Outcome advance(std::size_t k) override;
  void record(ProbeHistory& history) override;

 private:
  static int local_weights(N_Vector y, N_Vector inverse, void* data) noexcept;

  void create_solver(double t);
  void count_restart(double t, bool smooth);
  [[nodiscard]] Outcome take_internal_step();
  void collect_counts();
  [[nodiscard]] bool differentiate(double t, int k) override {
    return CVodeGetDky(cvode_.get(), t, k, derivative_.get()) == 0;
  }

  std::optional<double> atol_;
  bool local_;
  std::vector<double> spans_;
  sundials::Cvode cvode_;
  double t_begin_ = 0, t_internal_ = 0, end_ = 0;
  std::size_t breakpoints_ = 0, passed_ = 0, restarts_ = 0;
};

/// SUNDIALS' own rtol |y| + atol, where y is what the user calls it.
int CvodeBdf::local_weights(N_Vector y, N_Vector inverse, void* data) noexcept {
  const auto& method = static_cast<const CvodeBdf&>(
      *static_cast<SundialsPropagator*>(static_cast<SundialsCallbackData*>(data)->integrator));
  const auto values = sundials::entries(y), out = sundials::entries(inverse);
  const auto fields = method.rhs_->fields();
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const double atol = method.atol_.value_or(method.rtol_ * method.spans_[f]);
    for (std::size_t k = 0, i = fields[f].offset; k < fields[f].count; ++k, i += fields[f].stride)
      out[i] = 1 / (method.rtol_ * std::abs(values[i] + fields[f].origin) + atol);
  }
  return 0;
}

void CvodeBdf::prepare(Rhs& rhs, const Task& task) {
  cvode_.reset();
  spans_ = task.spans;
  t_begin_ = task.t_begin;
  breakpoints_ = task.propagations - 1;
  passed_ = restarts_ = 0;
  prepare_vectors(rhs, task);
  create_solver(task.t_begin);
}

void CvodeBdf::create_solver(double t) {
  cvode_.reset(CVodeCreate(CV_BDF, context_.get()));
  if (!cvode_) throw std::runtime_error("CVODE: out of memory");
  SundialsPropagator* self = this;
  check_sundials(CVodeSetErrHandlerFn(cvode_.get(), keep_message, self), "setting the error handler");
  check_sundials(CVodeInit(cvode_.get(), derivative, t, y_.get()), "initialisation");
  check_sundials(CVodeSetUserData(cvode_.get(), &callback_data_), "setting user data");
  check_sundials(CVodeWFtolerances(cvode_.get(), local_ ? local_weights : weights), "setting tolerances");
  check_sundials(CVodeSetMaxNumSteps(cvode_.get(), -1), "lifting the step limit");  // one step a call here
  (void)attach_linear_solver(SundialsPackage::cvode, cvode_.get());
}

/// Every fresh start begins with steps of order 1, whose errors have one sign: those of many starts add up
/// where nothing lets them decay, as in the heat that an insulated network keeps. So they share the
/// tolerance.
///   smooth  whether the run has just passed a breakpoint without starting afresh
void CvodeBdf::count_restart(double t, bool smooth) {
  constexpr double few = 4, smallest_part = 0.01;
  if (t > t_begin_) {
    ++passed_;
    restarts_ += smooth ? 0 : 1;
  } else {
    passed_ = restarts_ = 0;
  }
  const double seen = passed_ > 0 ? static_cast<double>(restarts_) / static_cast<double>(passed_) : 1;
  part_of_share_ = std::max(1 / (1 + seen * static_cast<double>(breakpoints_) / few), smallest_part);
}

void CvodeBdf::begin(double t, double end, std::span<const double> y, std::span<const Instant> instants,
                     bool smooth) {
  instants_ = instants;
  end_ = end;
  count_restart(t, smooth);
  if (!smooth || !has_history_) {
    collect_counts();
    begin_anew(y);
    check_sundials(CVodeReInit(cvode_.get(), t, y_.get()), "restart");
    t_internal_ = t;
  }
  t_ = t;
  if (std::isfinite(end)) check_sundials(CVodeSetStopTime(cvode_.get(), end), "setting the stop time");
}

void CvodeBdf::record(ProbeHistory& history) {
  if (!std::exchange(stepped_, false)) return;
  int order = 0;
  CVodeGetLastOrder(cvode_.get(), &order);
  record_taylor(t_internal_, order, history);
}

void CvodeBdf::collect_counts() {
  if (!has_history_) return;
  PackageCounts counts;
  long int convergence_failures = 0;
  CVodeGetNumSteps(cvode_.get(), &counts.steps);
  CVodeGetNumErrTestFails(cvode_.get(), &counts.rejected);
  CVodeGetNumLinSolvSetups(cvode_.get(), &counts.setups);
  CVodeGetNumNonlinSolvIters(cvode_.get(), &counts.iterations);
  CVodeGetNumNonlinSolvConvFails(cvode_.get(), &convergence_failures);
  counts.rejected += convergence_failures;
  take_counts(counts);
}

Outcome CvodeBdf::take_internal_step() {
  const double begin = t_internal_;
  const double towards = std::isfinite(end_) ? end_ : instants_.back().t;
  const int flag = CVode(cvode_.get(), towards, y_.get(), &t_internal_, CV_ONE_STEP);
  has_history_ = true;
  collect_counts();
  if (flag < 0) return failure("CVODE", t_internal_, flag);
  stepped_ = true;
  if (plan_->track_inflow) add_inflow(begin, std::min(t_internal_, plan_->output_times.back()));
  return {};
}

/// One internal step, or the interpolation at an instant that it has passed.
Outcome CvodeBdf::advance(std::size_t k) {
  const double t_out = instants_[k].t;
  if (t_internal_ < t_out)
    if (Outcome outcome = take_internal_step(); !outcome.ok()) return outcome;
  const bool beyond = t_internal_ > t_out;
  t_ = beyond ? t_out : t_internal_;
  if (beyond && !differentiate(t_out, 0)) return failure("CVODE", t_internal_, CV_BAD_T);
  show(beyond ? derivative_.get() : y_.get());
  return {};
}

std::vector<OptionKey> cvode_keys() {
  std::vector<OptionKey> keys = {tolerance_key("1e-6")};
  keys.push_back({.name = "tolerance",
                  .type = OptionKey::Type::word,
                  .words = {"span", "local"},
                  .fallback = "span",
                  .meaning = "span: rtol as everywhere; local: SUNDIALS' own, rtol |y| + atol a step"});
  keys.push_back({.name = "atol",
                  .min = 0,
                  .min_open = true,
                  .fallback = "rtol times the span",
                  .meaning = "with tolerance=local: local error allowed on top, in the field's unit"});
  keys.push_back({.name = "linsol",
                  .type = OptionKey::Type::word,
                  .words = {"auto", "klu", "cholmod", "pcg", "gmres"},
                  .fallback = "auto",
                  .meaning = "sparse LU, sparse Cholesky, or Krylov methods behind incomplete Cholesky; auto "
                             "takes the fastest"});
  keys.push_back({.name = "ordering",
                  .type = OptionKey::Type::word,
                  .words = {"auto", "metis", "amd", "colamd"},
                  .fallback = "auto",
                  .meaning = "klu: fill-reducing ordering"});
  return keys;
}

}  // namespace

IntegratorEntry cvode_entry() {
  return {.name = "cvode",
          .summary = "SUNDIALS CVODE, variable-order BDF",
          .source = "Hindmarsh et al. (2005), doi:10.1145/1089014.1089020",
          .colour = "#a44fa0",
          .order = 0,
          .adaptive = true,
          .distributed = Distributed::exact,
          .gathered_where = "but for linsol=pcg on linear scenes",
          .keys = cvode_keys(),
          .examples = {"cvode:rtol=1e-4,ordering=amd", "cvode:rtol=1e-9", "cvode:rtol=1e-7,linsol=pcg",
                       "cvode:rtol=1e-7,linsol=gmres", "cvode:rtol=1e-7,linsol=cholmod"},
          .representatives = {"cvode:rtol=1e-3,linsol=klu", "cvode:rtol=1e-3"},
          .ladder = joined({rtol_ladder("cvode:linsol=pcg", 2, 9), rtol_ladder("cvode:linsol=gmres", 2, 9),
                            rtol_ladder("cvode:linsol=klu", 2, 8, 2),
                            rtol_ladder("cvode:linsol=cholmod", 2, 8, 2)}),
          .make = [](const Options& options) { return std::make_unique<CvodeBdf>(options); }};
}

}  // namespace superstep
