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
#include "integrators/detail/implicit/cvode_linear_solver.hpp"
#include "integrators/detail/implicit/shifted_solver.hpp"
#include "integrators/detail/implicit/sundials.hpp"
#include "integrators/detail/tolerance.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

constexpr double default_rtol = 1e-6;
constexpr int largest_order = 5;

/// Part of the tolerance that a step's local error may have. Fitted once, to the audit's scenes
/// (tests/audit).
double local_share(double rtol) {
  return std::min(0.2, std::pow(rtol, 0.15));
}

class CvodeBdf final : public Propagator {
 public:
  explicit CvodeBdf(const Options& options)
      : rtol_(options.number("rtol").value_or(default_rtol)),
        atol_(options.number("atol")),
        local_(options.word("tolerance", "span") == "local"),
        linsol_(options.word("linsol", options.has("ordering") ? "klu" : "auto")),
        ordering_(options.word("ordering", "auto")) {
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
  static void keep_message(int code, const char* module, const char* function, char* message,
                           void* self) noexcept;

  void create_solver(double t);
  [[nodiscard]] Outcome take_internal_step();
  /// Inflow over the internal step just made, by Gauss points on its interpolant.
  [[nodiscard]] double inflow_of_step(double begin, double end);
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
  std::unique_ptr<CvodeLinearSolver> linear_solver_;
  CvodeCallbackData callback_data_;
  sundials::Cvode cvode_;
  double t_ = 0, t_internal_ = 0, end_ = 0;
  bool stepped_ = false;  ///< since `record` was called last
  bool has_history_ = false;
  std::string message_;
  Statistics counts_, before_restart_;
};

int CvodeBdf::derivative(double t, N_Vector y, N_Vector ydot, void* data) noexcept {
  (*static_cast<CvodeCallbackData*>(data)->rhs)(t, sundials::entries(y), sundials::entries(ydot));
  return 0;
}

/// Local errors of the run's tolerance times a factor that makes what is delivered proportional to it; or
/// SUNDIALS' own rtol |y| + atol.
int CvodeBdf::weights(N_Vector y, N_Vector inverse, void* data) noexcept {
  const auto& method = *static_cast<CvodeBdf*>(static_cast<CvodeCallbackData*>(data)->integrator);
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
  const double share = local_share(method.rtol_);
  constexpr double roundings = 8 * std::numeric_limits<double>::epsilon();  // below them no step would pass
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double weight = method.norm_.weight(i);
    out[i] = weight > 0 ? 1 / std::max(share / weight, roundings * std::abs(values[i])) : 1e-30;
  }
  return 0;
}

void CvodeBdf::keep_message(int /*code*/, const char* /*module*/, const char* function, char* message,
                            void* self) noexcept {
  try {
    static_cast<CvodeBdf*>(self)->message_ = fmt::format("{}: {}", function, message);
  } catch (...) {  // out of memory while reporting: the flag alone has to do
  }
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
  taylor_.resize(plan_->probes.size() * (largest_order + 1));
}

void CvodeBdf::create_solver(double t) {
  const bool automatic = linsol_ == "auto";
  const std::string linsol = automatic ? fastest_linear_solver(*rhs_) : linsol_;
  const std::string ordering = ordering_ == "auto" ? fastest_klu_ordering(*rhs_) : ordering_;
  if (automatic) choice_ = linsol == "klu" ? "linsol=klu,ordering=" + ordering : "linsol=" + linsol;
  linear_solver_ = make_cvode_linear_solver(linsol, ordering, *rhs_, y_.get(), context_.get());
  callback_data_ = {rhs_, this, linear_solver_.get()};
  cvode_.reset(CVodeCreate(CV_BDF, context_.get()));
  if (!cvode_) throw std::runtime_error("CVODE: out of memory");
  check_sundials(CVodeSetErrHandlerFn(cvode_.get(), keep_message, this), "setting the error handler");
  check_sundials(CVodeInit(cvode_.get(), derivative, t, y_.get()), "initialisation");
  check_sundials(CVodeSetUserData(cvode_.get(), &callback_data_), "setting user data");
  check_sundials(CVodeWFtolerances(cvode_.get(), weights), "setting tolerances");
  check_sundials(CVodeSetMaxNumSteps(cvode_.get(), -1), "lifting the step limit");  // one step a call here
  linear_solver_->attach(cvode_.get());
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
  const std::size_t probes = plan_->probes.size();
  double factorial = 1;
  for (int k = 0; k <= order; ++k) {
    if (k > 1) factorial *= k;
    if (!differentiate(t_internal_, k)) return;
    const auto values = sundials::entries(derivative_.get());
    for (std::size_t p = 0; p < probes; ++p)
      taylor_[static_cast<std::size_t>(k) * probes + p] = values[plan_->probes[p]] / factorial;
  }
  history.append(t_internal_, std::span(taylor_).first((static_cast<std::size_t>(order) + 1) * probes),
                 order);
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
          fmt::format("CVODE stopped at t = {:.6g} s with flag {}: {}", t_internal_, flag, message_)};
}

double CvodeBdf::inflow_of_step(double begin, double end) {
  static constexpr double node = 0.7745966692414834;  // sqrt(3/5): Gauss-Legendre, exact to degree 5
  const double middle = 0.5 * (begin + end), half = 0.5 * (end - begin);
  double sum = 0;
  for (const auto& [position, weight] : {std::pair{-node, 5.0 / 9}, {0.0, 8.0 / 9}, {node, 5.0 / 9}}) {
    const double t = middle + position * half;
    if (differentiate(t, 0)) sum += weight * half * rhs_->inflow(t, sundials::entries(derivative_.get()));
  }
  return sum;
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
    counts_.inflow += inflow_of_step(begin, std::min(t_internal_, plan_->output_times.back()));
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
