/// CVODE's variable-order BDF; with a sparse direct solver the reference of the harness.
/// Source: Hindmarsh et al. (2005), SUNDIALS, doi:10.1145/1089014.1089020; KLU: Davis & Palamadai Natarajan
/// (2010), doi:10.1145/1824801.1824814.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "integrators/detail/error_norm.hpp"
#include "integrators/detail/implicit/shifted_solver.hpp"
#include "integrators/detail/implicit/sundials_linear_solver.hpp"
#include "integrators/detail/implicit/sundials_run.hpp"
#include "integrators/detail/tolerance.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

/// Part of the tolerance that a step's local error may have. Fitted once, to the audit's scenes
/// (tests/audit).
double local_share(double rtol) {
  return std::min(0.2, std::pow(rtol, 0.15));
}

class CvodeBdf final : public Propagator {
 public:
  explicit CvodeBdf(const Options& options)
      : rtol_(options.number("rtol")),
        atol_(options.given("atol")),
        local_(options.word("tolerance") == "local"),
        linsol_(options.has("ordering") && !options.has("linsol") ? "klu" : options.word("linsol")),
        ordering_(options.word("ordering")) {
    if (options.has("ordering") && linsol_ != "klu")
      throw UsageError("cvode: ordering goes with linsol=klu; leave it out, or choose that");
    if (atol_ && !local_)
      throw UsageError("cvode: atol goes with tolerance=local; leave it out, or choose that");
  }

  void prepare(Rhs& rhs, const Task& task) override;
  [[nodiscard]] double rtol() const override { return rtol_; }
  void begin(double t, double end, std::span<const double> y, std::span<const Instant> instants,
             bool smooth) override;
  Outcome advance(std::size_t k) override;
  [[nodiscard]] double time() const noexcept override { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept override { return state_; }
  [[nodiscard]] bool stops_on_the_way() const noexcept override { return true; }
  void record(ProbeHistory& history) override;
  void reset_counts() override { counts_ = {}; }
  void add_counts(Statistics& statistics) const override;
  [[nodiscard]] std::string choice() const override { return choice_; }

 private:
  static int derivative(double t, N_Vector y, N_Vector ydot, void* data) noexcept;
  static int weights(N_Vector y, N_Vector inverse, void* data) noexcept;

  void create_solver(double t);
  [[nodiscard]] Outcome take_internal_step();
  void collect_counts();
  [[nodiscard]] Outcome failure(int flag) const;
  [[nodiscard]] bool differentiate(double t, int k);

  double rtol_;
  std::optional<double> atol_;
  bool local_;
  std::string linsol_, ordering_, choice_;
  Rhs* rhs_ = nullptr;
  const Plan* plan_ = nullptr;
  std::span<const Instant> instants_;
  ErrorNorm norm_;
  std::vector<double> spans_, state_, taylor_;
  // Destroyed from the last to the first: the solver before what it uses.
  sundials::Context context_;
  sundials::Vector y_, derivative_;
  std::unique_ptr<SundialsLinearSolver> linear_solver_;
  SundialsCallbackData callback_data_;
  sundials::Cvode cvode_;
  double t_ = 0, t_internal_ = 0, end_ = 0;
  bool stepped_ = false;  ///< since `record` was called last
  bool has_history_ = false;
  sundials::Message message_;
  Statistics counts_, before_restart_;
};

int CvodeBdf::derivative(double t, N_Vector y, N_Vector ydot, void* data) noexcept {
  (*static_cast<SundialsCallbackData*>(data)->rhs)(t, sundials::entries(y), sundials::entries(ydot));
  return 0;
}

/// Local errors of the run's tolerance times a factor that makes what is delivered proportional to it; or
/// SUNDIALS' own rtol |y| + atol.
int CvodeBdf::weights(N_Vector y, N_Vector inverse, void* data) noexcept {
  const auto& method = *static_cast<CvodeBdf*>(static_cast<SundialsCallbackData*>(data)->integrator);
  const auto values = sundials::entries(y), out = sundials::entries(inverse);
  if (method.local_) {
    const auto fields = method.rhs_->fields();
    for (std::size_t f = 0; f < fields.size(); ++f) {
      const double atol = method.atol_.value_or(method.rtol_ * method.spans_[f]);
      for (std::size_t k = 0, i = fields[f].offset; k < fields[f].count; ++k, i += fields[f].stride)
        out[i] = 1 / (method.rtol_ * std::abs(values[i]) + atol);
    }
    return 0;
  }
  sundials::set_weights(method.norm_, local_share(method.rtol_), y, inverse);
  return 0;
}

void CvodeBdf::prepare(Rhs& rhs, const Task& task) {
  rhs_ = &rhs;
  plan_ = task.plan;
  spans_ = task.spans;
  norm_.prepare(rhs, task.allowed);
  cvode_.reset();
  linear_solver_.reset();
  context_ = sundials::make_context();
  y_.reset(sundials::new_state_vector(rhs.reduction(), context_.get()));
  derivative_.reset(sundials::new_state_vector(rhs.reduction(), context_.get()));
  if (!y_ || !derivative_) throw std::bad_alloc();
  create_solver(task.t_begin);
  state_.resize(rhs.size());
}

void CvodeBdf::create_solver(double t) {
  const bool automatic = linsol_ == "auto";
  const std::string linsol = automatic ? fastest_linear_solver(*rhs_) : linsol_;
  const std::string ordering = ordering_ == "auto" ? fastest_klu_ordering(*rhs_) : ordering_;
  if (automatic) choice_ = linsol == "klu" ? "linsol=klu,ordering=" + ordering : "linsol=" + linsol;
  linear_solver_ = make_sundials_linear_solver(linsol, ordering, *rhs_, y_.get(), context_.get());
  callback_data_ = {rhs_, this, linear_solver_.get()};
  cvode_.reset(CVodeCreate(CV_BDF, context_.get()));
  if (!cvode_) throw std::runtime_error("CVODE: out of memory");
  check_sundials(CVodeSetErrHandlerFn(cvode_.get(), sundials::Message::keep, &message_),
                 "setting the error handler");
  check_sundials(CVodeInit(cvode_.get(), derivative, t, y_.get()), "initialisation");
  check_sundials(CVodeSetUserData(cvode_.get(), &callback_data_), "setting user data");
  check_sundials(CVodeWFtolerances(cvode_.get(), weights), "setting tolerances");
  check_sundials(CVodeSetMaxNumSteps(cvode_.get(), -1), "lifting the step limit");  // one step a call here
  linear_solver_->attach(SundialsPackage::cvode, cvode_.get());
}

void CvodeBdf::begin(double t, double end, std::span<const double> y, std::span<const Instant> instants,
                     bool smooth) {
  instants_ = instants;
  end_ = end;
  if (!smooth || !has_history_) {
    collect_counts();
    before_restart_ = counts_;
    std::copy(y.begin(), y.end(), sundials::entries(y_.get()).begin());
    std::copy(y.begin(), y.end(), state_.begin());
    check_sundials(CVodeReInit(cvode_.get(), t, y_.get()), "restart");
    has_history_ = false;
    t_internal_ = t;
  }
  t_ = t;
  if (std::isfinite(end)) check_sundials(CVodeSetStopTime(cvode_.get(), end), "setting the stop time");
}

bool CvodeBdf::differentiate(double t, int k) {
  return CVodeGetDky(cvode_.get(), t, k, derivative_.get()) == 0;
}

void CvodeBdf::record(ProbeHistory& history) {
  if (!std::exchange(stepped_, false)) return;
  int order = 0;
  CVodeGetLastOrder(cvode_.get(), &order);
  sundials::record_taylor(
      t_internal_, order, plan_->probes, derivative_.get(),
      [this](double t, int k) { return differentiate(t, k); }, taylor_, history);
}

void CvodeBdf::collect_counts() {
  if (!has_history_) return;
  long int steps = 0, failures = 0, setups = 0, iterations = 0, convergence_failures = 0;
  CVodeGetNumSteps(cvode_.get(), &steps);
  CVodeGetNumErrTestFails(cvode_.get(), &failures);
  CVodeGetNumLinSolvSetups(cvode_.get(), &setups);
  CVodeGetNumNonlinSolvIters(cvode_.get(), &iterations);
  CVodeGetNumNonlinSolvConvFails(cvode_.get(), &convergence_failures);
  counts_.steps = before_restart_.steps + static_cast<std::uint64_t>(steps);
  counts_.rejected = before_restart_.rejected + static_cast<std::uint64_t>(failures + convergence_failures);
  counts_.factorizations = before_restart_.factorizations + static_cast<std::uint64_t>(setups);
  counts_.solves = before_restart_.solves + static_cast<std::uint64_t>(iterations);
}

void CvodeBdf::add_counts(Statistics& statistics) const {
  statistics.steps += counts_.steps;
  statistics.rejected += counts_.rejected;
  statistics.factorizations += counts_.factorizations;
  statistics.solves += counts_.solves;
  statistics.inflow += counts_.inflow;
}

Outcome CvodeBdf::failure(int flag) const {
  return {Status::failed,
          fmt::format("CVODE stopped at t = {:.6g} s with flag {}: {}", t_internal_, flag, message_.text)};
}

Outcome CvodeBdf::take_internal_step() {
  const double begin = t_internal_;
  const double towards = std::isfinite(end_) ? end_ : instants_.back().t;
  const int flag = CVode(cvode_.get(), towards, y_.get(), &t_internal_, CV_ONE_STEP);
  has_history_ = true;
  collect_counts();
  if (flag < 0) return failure(flag);
  stepped_ = true;
  if (plan_->track_inflow)
    counts_.inflow +=
        sundials::inflow_between(*rhs_, begin, std::min(t_internal_, plan_->output_times.back()),
                                 derivative_.get(), [this](double t, int k) { return differentiate(t, k); });
  return {};
}

/// One internal step, or the interpolation at an instant that it has passed.
Outcome CvodeBdf::advance(std::size_t k) {
  const double t_out = instants_[k].t;
  if (t_internal_ < t_out)
    if (Outcome outcome = take_internal_step(); !outcome.ok()) return outcome;
  const bool beyond = t_internal_ > t_out;
  t_ = beyond ? t_out : t_internal_;
  if (beyond && !differentiate(t_out, 0)) return failure(CV_BAD_T);
  const auto values = sundials::entries(beyond ? derivative_.get() : y_.get());
  std::copy(values.begin(), values.end(), state_.begin());
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
