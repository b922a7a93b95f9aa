/// SUNDIALS ARKODE: explicit and diagonally implicit Runge-Kutta methods as its users would run them, on the
/// same right-hand side and with the same linear solvers as the others. Source: Reynolds et al. (2023),
/// doi:10.1145/3594632.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
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

constexpr int interpolant = 3;  // derivatives that the package's Hermite interpolant has at every order

/// Part of the tolerance that a step's local error may have: as in cvode.cpp, for the same reason.
double local_share(double rtol) {
  return std::min(0.2, std::pow(rtol, 0.15));
}

class ArkodeRungeKutta final : public Propagator {
 public:
  explicit ArkodeRungeKutta(const Options& options)
      : rtol_(options.number("rtol")),
        implicit_(options.word("method") == "dirk"),
        order_(options.integer("order")),
        linsol_(options.word("linsol")) {
    if (!implicit_ && options.has("linsol"))
      throw UsageError("arkode: linsol goes with method=dirk; leave it out, or choose that");
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
  void attach_linear_solver();
  void collect_counts();
  [[nodiscard]] bool differentiate(double t, int k) {
    return ARKStepGetDky(arkode_.get(), t, k, derivative_.get()) == 0;
  }
  [[nodiscard]] ARKRhsFn explicit_part() const { return implicit_ ? nullptr : derivative; }
  [[nodiscard]] ARKRhsFn implicit_part() const { return implicit_ ? derivative : nullptr; }

  double rtol_;
  bool implicit_;
  int order_;
  std::string linsol_, choice_;
  Rhs* rhs_ = nullptr;
  const Plan* plan_ = nullptr;
  std::span<const Instant> instants_;
  ErrorNorm norm_;
  std::vector<double> state_, taylor_;
  // Destroyed from the last to the first: the solver before what it uses.
  sundials::Context context_;
  sundials::Vector y_, derivative_;
  std::unique_ptr<SundialsLinearSolver> linear_solver_;
  SundialsCallbackData callback_data_;
  sundials::Arkode arkode_;
  double t_ = 0, stop_ = 0;
  bool stepped_ = false;  ///< since `record` was called last
  bool has_history_ = false;
  sundials::Message message_;
  Statistics counts_, before_restart_;
};

int ArkodeRungeKutta::derivative(double t, N_Vector y, N_Vector ydot, void* data) noexcept {
  (*static_cast<SundialsCallbackData*>(data)->rhs)(t, sundials::entries(y), sundials::entries(ydot));
  return 0;
}

int ArkodeRungeKutta::weights(N_Vector y, N_Vector inverse, void* data) noexcept {
  const auto& method = *static_cast<ArkodeRungeKutta*>(static_cast<SundialsCallbackData*>(data)->integrator);
  sundials::set_weights(method.norm_, local_share(method.rtol_), y, inverse);
  return 0;
}

void ArkodeRungeKutta::prepare(Rhs& rhs, const Task& task) {
  rhs_ = &rhs;
  plan_ = task.plan;
  norm_.prepare(rhs, task.allowed);
  arkode_.reset();
  linear_solver_.reset();
  context_ = sundials::make_context();
  y_.reset(sundials::new_state_vector(rhs.reduction(), context_.get()));
  derivative_.reset(sundials::new_state_vector(rhs.reduction(), context_.get()));
  if (!y_ || !derivative_) throw std::bad_alloc();
  N_VConst(0, y_.get());
  create_solver(task.t_begin);
  state_.resize(rhs.size());
  has_history_ = false;
}

void ArkodeRungeKutta::create_solver(double t) {
  arkode_.reset(ARKStepCreate(explicit_part(), implicit_part(), t, y_.get(), context_.get()));
  if (!arkode_) throw std::runtime_error("ARKODE: out of memory");
  void* arkode = arkode_.get();
  check_sundials(ARKStepSetErrHandlerFn(arkode, sundials::Message::keep, &message_),
                 "setting the error handler");
  callback_data_ = {rhs_, this, nullptr};
  check_sundials(ARKStepSetUserData(arkode, &callback_data_), "setting user data");
  check_sundials(ARKStepSetOrder(arkode, order_), "setting the order");
  check_sundials(ARKStepWFtolerances(arkode, weights), "setting tolerances");
  check_sundials(ARKStepSetMaxNumSteps(arkode, -1), "lifting the step limit");  // one step a call here
  if (implicit_) attach_linear_solver();
}

void ArkodeRungeKutta::attach_linear_solver() {
  const bool automatic = linsol_ == "auto";
  const std::string linsol = automatic ? fastest_linear_solver(*rhs_) : linsol_;
  const std::string ordering = fastest_klu_ordering(*rhs_);
  if (automatic) choice_ = linsol == "klu" ? "linsol=klu,ordering=" + ordering : "linsol=" + linsol;
  linear_solver_ = make_sundials_linear_solver(linsol, ordering, *rhs_, y_.get(), context_.get());
  callback_data_.linear_solver = linear_solver_.get();
  linear_solver_->attach(SundialsPackage::arkode, arkode_.get());
  // One Newton iteration is all that a linear system needs, where the linear solver is exact.
  const bool direct = linsol == "klu" || linsol == "cholmod";
  if (rhs_->traits().linear && direct)
    check_sundials(ARKStepSetLinear(arkode_.get(), 0), "saying that the system is linear");
}

void ArkodeRungeKutta::begin(double t, double /*end*/, std::span<const double> y,
                             std::span<const Instant> instants, bool smooth) {
  instants_ = instants;
  t_ = t;
  stop_ = t;
  if (smooth && has_history_) return;
  collect_counts();
  before_restart_ = counts_;
  std::copy(y.begin(), y.end(), sundials::entries(y_.get()).begin());
  std::copy(y.begin(), y.end(), state_.begin());
  check_sundials(ARKStepReInit(arkode_.get(), explicit_part(), implicit_part(), t, y_.get()), "restart");
  has_history_ = false;
}

/// One step, ending at instant number k at the latest: interpolants are of lower order than the steps.
Outcome ArkodeRungeKutta::advance(std::size_t k) {
  const double t_out = instants_[k].t;
  if (stop_ != t_out) {
    check_sundials(ARKStepSetStopTime(arkode_.get(), t_out), "setting the stop time");
    stop_ = t_out;
  }
  // The package does not begin what ends within rounding: breakpoints and outputs may lie so close.
  if (constexpr double roundings = 16 * std::numeric_limits<double>::epsilon();
      t_out - t_ <= roundings * std::max(std::abs(t_), std::abs(t_out))) {
    t_ = t_out;
    return {};
  }
  const double begin = t_;
  const int flag = ARKStepEvolve(arkode_.get(), t_out, y_.get(), &t_, ARK_ONE_STEP);
  has_history_ = true;
  collect_counts();
  if (flag < 0)
    return {Status::failed,
            fmt::format("ARKODE stopped at t = {:.6g} s with flag {}: {}", t_, flag, message_.text)};
  stepped_ = true;
  if (plan_->track_inflow)
    counts_.inflow += sundials::inflow_between(*rhs_, begin, t_, derivative_.get(),
                                               [this](double t, int n) { return differentiate(t, n); });
  const auto values = sundials::entries(y_.get());
  std::copy(values.begin(), values.end(), state_.begin());
  return {};
}

void ArkodeRungeKutta::record(ProbeHistory& history) {
  if (!std::exchange(stepped_, false)) return;
  const int order = std::min(interpolant, order_ - 1);
  sundials::record_taylor(
      t_, order, plan_->probes, derivative_.get(), [this](double t, int k) { return differentiate(t, k); },
      taylor_, history);
}

void ArkodeRungeKutta::collect_counts() {
  if (!has_history_) return;
  long int steps = 0, failures = 0, setups = 0, iterations = 0;
  ARKStepGetNumSteps(arkode_.get(), &steps);
  ARKStepGetNumErrTestFails(arkode_.get(), &failures);
  if (implicit_) {
    ARKStepGetNumLinSolvSetups(arkode_.get(), &setups);
    ARKStepGetNumNonlinSolvIters(arkode_.get(), &iterations);
  }
  counts_.steps = before_restart_.steps + static_cast<std::uint64_t>(steps);
  counts_.rejected = before_restart_.rejected + static_cast<std::uint64_t>(failures);
  counts_.factorizations = before_restart_.factorizations + static_cast<std::uint64_t>(setups);
  counts_.solves = before_restart_.solves + static_cast<std::uint64_t>(iterations);
}

void ArkodeRungeKutta::add_counts(Statistics& statistics) const {
  statistics.steps += counts_.steps;
  statistics.rejected += counts_.rejected;
  statistics.factorizations += counts_.factorizations;
  statistics.solves += counts_.solves;
  statistics.inflow += counts_.inflow;
}

}  // namespace

IntegratorEntry arkode_entry() {
  return {
      .name = "arkode",
      .summary = "SUNDIALS ARKODE, explicit and diagonally implicit Runge-Kutta methods",
      .source = "Reynolds et al. (2023), doi:10.1145/3594632",
      .colour = "#6e5c9e",
      .order = 0,
      .adaptive = true,
      .keys = {tolerance_key("1e-6"),
               {.name = "method",
                .type = OptionKey::Type::word,
                .words = {"dirk", "erk"},
                .fallback = "dirk",
                .meaning = "diagonally implicit, or explicit"},
               {.name = "order",
                .type = OptionKey::Type::integer,
                .min = 2,
                .max = 5,
                .fallback = "4",
                .meaning = "of the package's default method"},
               {.name = "linsol",
                .type = OptionKey::Type::word,
                .words = {"auto", "klu", "cholmod", "pcg", "gmres"},
                .fallback = "auto",
                .meaning = "dirk: as of cvode"}},
      .examples = {"arkode:rtol=1e-7,method=erk", "arkode:rtol=1e-7,order=3", "arkode:rtol=1e-8,linsol=pcg"},
      .representatives = {"arkode:rtol=1e-3"},
      .ladder =
          joined({rtol_ladder("arkode", 2, 8, 2), rtol_ladder("arkode:order=3", 2, 4, 2),
                  rtol_ladder("arkode:linsol=pcg", 2, 8, 2), rtol_ladder("arkode:method=erk", 2, 8, 2)}),
      .make = [](const Options& options) { return std::make_unique<ArkodeRungeKutta>(options); }};
}

}  // namespace superstep
