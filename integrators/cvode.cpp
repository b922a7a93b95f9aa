/// CVODE's variable-order BDF; with a sparse direct solver the reference of the harness.
/// Source: Hindmarsh et al. (2005), SUNDIALS, doi:10.1145/1089014.1089020; KLU: Davis & Palamadai Natarajan
/// (2010), doi:10.1145/1824801.1824814.

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "integrators/detail/cvode_linear_solver.hpp"
#include "integrators/detail/error_weights.hpp"
#include "integrators/detail/run_guard.hpp"
#include "integrators/detail/shifted_solver.hpp"
#include "integrators/detail/sundials.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

constexpr double default_rtol = 1e-6;
constexpr int largest_order = 5;

class CvodeBdf final : public Integrator {
 public:
  explicit CvodeBdf(const Options& options)
      : rtol_(options.number("rtol").value_or(default_rtol)),
        atol_(options.number("atol").value_or(0.0)),
        linsol_(options.word("linsol", options.has("ordering") ? "klu" : "auto")),
        ordering_(options.word("ordering", "auto")) {
    if (options.has("ordering") && linsol_ != "klu")
      throw UsageError("cvode: ordering goes with linsol=klu; leave it out, or choose that");
  }

  void prepare(Rhs& rhs, const Plan& plan) override;
  void start(double t, std::span<const double> y) override;
  Outcome advance(double t_out) override;
  [[nodiscard]] double time() const noexcept override { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept override { return state_; }
  [[nodiscard]] const Statistics& statistics() const noexcept override { return statistics_; }
  [[nodiscard]] std::string choice() const override { return choice_; }

 private:
  static int derivative(double t, N_Vector y, N_Vector ydot, void* data) noexcept;
  static int inflow(double t, N_Vector y, N_Vector qdot, void* data) noexcept;
  static int weights(N_Vector y, N_Vector inverse, void* data) noexcept;
  static void keep_message(int code, const char* module, const char* function, char* message,
                           void* self) noexcept;

  void create_solver(double t);
  void record_step();
  void collect_counts();
  [[nodiscard]] Outcome failure(int flag) const;

  double rtol_, atol_;
  std::string linsol_, ordering_, choice_;
  Rhs* rhs_ = nullptr;
  Plan plan_;
  RunGuard guard_;
  ErrorWeights error_weights_;
  std::vector<double> state_, taylor_;
  // Destroyed from the last to the first: the solver before what it uses.
  sundials::Context context_;
  sundials::Vector y_, derivative_, quadrature_;
  std::unique_ptr<CvodeLinearSolver> linear_solver_;
  CvodeCallbackData callback_data_;
  sundials::Cvode cvode_;
  double t_ = 0, t_internal_ = 0;
  std::string message_;
  Statistics statistics_;
};

int CvodeBdf::derivative(double t, N_Vector y, N_Vector ydot, void* data) noexcept {
  (*static_cast<CvodeCallbackData*>(data)->rhs)(t, sundials::entries(y), sundials::entries(ydot));
  return 0;
}

int CvodeBdf::inflow(double t, N_Vector y, N_Vector qdot, void* data) noexcept {
  sundials::entries(qdot)[0] = static_cast<CvodeCallbackData*>(data)->rhs->inflow(t, sundials::entries(y));
  return 0;
}

int CvodeBdf::weights(N_Vector y, N_Vector inverse, void* data) noexcept {
  auto& method = *static_cast<CvodeBdf*>(static_cast<CvodeCallbackData*>(data)->integrator);
  const auto values = sundials::entries(y), out = sundials::entries(inverse);
  method.error_weights_.widen(values);
  method.error_weights_.fill(values, out);
  for (double& w : out) w = 1 / w;
  return 0;
}

void CvodeBdf::keep_message(int /*code*/, const char* /*module*/, const char* function, char* message,
                            void* self) noexcept {
  try {
    static_cast<CvodeBdf*>(self)->message_ = fmt::format("{}: {}", function, message);
  } catch (...) {  // out of memory while reporting: the flag alone has to do
  }
}

void CvodeBdf::prepare(Rhs& rhs, const Plan& plan) {
  rhs_ = &rhs;
  plan_ = plan;
  guard_.prepare(rhs, plan);
  error_weights_.prepare(rhs, plan, rtol_, atol_);
  context_ = sundials::make_context();
  const auto n = static_cast<sunindextype>(rhs.size());
  y_.reset(N_VNew_Serial(n, context_.get()));
  derivative_.reset(N_VNew_Serial(n, context_.get()));
  if (plan.track_inflow) quadrature_.reset(N_VNew_Serial(1, context_.get()));
  create_solver(plan.t_begin);
  state_.resize(rhs.size());
  taylor_.resize(plan.probes.size() * (largest_order + 1));
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
  if (quadrature_)
    check_sundials(CVodeQuadInit(cvode_.get(), inflow, quadrature_.get()), "adding the inflow quadrature");
}

void CvodeBdf::start(double t, std::span<const double> y) {
  rhs_->restart(t);
  std::copy(y.begin(), y.end(), sundials::entries(y_.get()).begin());
  std::copy(y.begin(), y.end(), state_.begin());
  error_weights_.restart();
  check_sundials(CVodeReInit(cvode_.get(), t, y_.get()), "restart");
  if (quadrature_) {
    N_VConst(0.0, quadrature_.get());
    check_sundials(CVodeQuadReInit(cvode_.get(), quadrature_.get()), "restart of the inflow quadrature");
  }
  t_ = t_internal_ = t;
  statistics_ = {};
}

void CvodeBdf::record_step() {
  if (!plan_.history) return;
  int order = 0;
  CVodeGetLastOrder(cvode_.get(), &order);
  const std::size_t probes = plan_.probes.size();
  double factorial = 1;
  for (int k = 0; k <= order; ++k) {
    if (k > 1) factorial *= k;
    CVodeGetDky(cvode_.get(), t_internal_, k, derivative_.get());
    const auto values = sundials::entries(derivative_.get());
    for (std::size_t p = 0; p < probes; ++p)
      taylor_[static_cast<std::size_t>(k) * probes + p] = values[plan_.probes[p]] / factorial;
  }
  plan_.history->append(t_internal_, std::span(taylor_).first((static_cast<std::size_t>(order) + 1) * probes),
                        order);
}

void CvodeBdf::collect_counts() {
  long int steps = 0, failures = 0, setups = 0, iterations = 0, convergence_failures = 0;
  CVodeGetNumSteps(cvode_.get(), &steps);
  CVodeGetNumErrTestFails(cvode_.get(), &failures);
  CVodeGetNumLinSolvSetups(cvode_.get(), &setups);
  CVodeGetNumNonlinSolvIters(cvode_.get(), &iterations);
  CVodeGetNumNonlinSolvConvFails(cvode_.get(), &convergence_failures);
  statistics_.steps = static_cast<std::uint64_t>(steps);
  statistics_.rejected = static_cast<std::uint64_t>(failures + convergence_failures);
  statistics_.factorizations = static_cast<std::uint64_t>(setups);
  statistics_.solves = static_cast<std::uint64_t>(iterations);
}

Outcome CvodeBdf::failure(int flag) const {
  return {Status::failed,
          fmt::format("CVODE stopped at t = {:.6g} s with flag {}: {}", t_internal_, flag, message_)};
}

Outcome CvodeBdf::advance(double t_out) {
  while (t_internal_ < t_out) {
    if (guard_.stop_requested(t_internal_)) return interrupted_at(t_internal_);
    const int flag = CVode(cvode_.get(), t_out, y_.get(), &t_internal_, CV_ONE_STEP);
    if (flag < 0) {
      collect_counts();
      return failure(flag);
    }
    record_step();
  }
  int flag = CVodeGetDky(cvode_.get(), t_out, 0, derivative_.get());
  if (flag == 0 && quadrature_) flag = CVodeGetQuadDky(cvode_.get(), t_out, 0, quadrature_.get());
  collect_counts();
  if (flag != 0) return failure(flag);
  if (quadrature_) statistics_.inflow = sundials::entries(quadrature_.get())[0];
  const auto values = sundials::entries(derivative_.get());
  std::copy(values.begin(), values.end(), state_.begin());
  t_ = t_out;
  return guard_.check(t_, state_);
}

std::vector<OptionKey> cvode_keys() {
  std::vector<OptionKey> keys = tolerance_keys("1e-6");
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
          .order = 0,
          .adaptive = true,
          .keys = cvode_keys(),
          .examples = {"cvode:rtol=1e-4,ordering=amd", "cvode:rtol=1e-9", "cvode:rtol=1e-7,linsol=pcg",
                       "cvode:rtol=1e-7,linsol=gmres", "cvode:rtol=1e-7,linsol=cholmod"},
          .ladder = joined({rtol_ladder("cvode:linsol=pcg", 2, 9), rtol_ladder("cvode:linsol=gmres", 2, 9),
                            rtol_ladder("cvode:linsol=klu", 2, 8, 2),
                            rtol_ladder("cvode:linsol=cholmod", 2, 8, 2)}),
          .make = [](const Options& options) { return std::make_unique<CvodeBdf>(options); }};
}

}  // namespace superstep
