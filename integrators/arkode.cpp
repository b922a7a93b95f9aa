/// SUNDIALS ARKODE: explicit and diagonally implicit Runge-Kutta methods as its users would run them, on the
/// same right-hand side and with the same linear solvers as the others. Source: Reynolds et al. (2023),
/// doi:10.1145/3594632.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "integrators/detail/implicit/sundials_propagator.hpp"
#include "integrators/detail/tolerance.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

constexpr int interpolant = 3;  // derivatives that the package's Hermite interpolant has at every order

class ArkodeRungeKutta final : public SundialsPropagator {
 public:
  explicit ArkodeRungeKutta(const Options& options)
      : SundialsPropagator(options.number("rtol"), options.word("linsol"), "auto"),
        implicit_(options.word("method") == "dirk"),
        order_(options.integer("order")) {
    if (!implicit_ && options.has("linsol"))
      throw UsageError("arkode: linsol goes with method=dirk; leave it out, or choose that");
  }

  void prepare(Rhs& rhs, const Task& task) override;
  void begin(double t, double end, std::span<const double> y, std::span<const Instant> instants,
             bool smooth) override;
  Outcome advance(std::size_t k) override;
  void record(ProbeHistory& history) override;

 private:
  void create_solver(double t);
  void collect_counts();
  [[nodiscard]] bool differentiate(double t, int k) override {
    return ARKStepGetDky(arkode_.get(), t, k, derivative_.get()) == 0;
  }
  [[nodiscard]] ARKRhsFn explicit_part() const { return implicit_ ? nullptr : derivative; }
  [[nodiscard]] ARKRhsFn implicit_part() const { return implicit_ ? derivative : nullptr; }

  bool implicit_;
  int order_;
  sundials::Arkode arkode_;
  double stop_ = 0;
};

void ArkodeRungeKutta::prepare(Rhs& rhs, const Task& task) {
  arkode_.reset();
  prepare_vectors(rhs, task);
  // Of a bend inside a step the two results of a pair know as little as each other.
  part_of_share_ = rhs.traits().smooth ? 1 : 0.01;
  create_solver(task.t_begin);
}

void ArkodeRungeKutta::create_solver(double t) {
  arkode_.reset(ARKStepCreate(explicit_part(), implicit_part(), t, y_.get(), context_.get()));
  if (!arkode_) throw std::runtime_error("ARKODE: out of memory");
  void* arkode = arkode_.get();
  SundialsPropagator* self = this;
  check_sundials(ARKStepSetErrHandlerFn(arkode, keep_message, self), "setting the error handler");
  check_sundials(ARKStepSetUserData(arkode, &callback_data_), "setting user data");
  check_sundials(ARKStepSetOrder(arkode, order_), "setting the order");
  check_sundials(ARKStepWFtolerances(arkode, weights), "setting tolerances");
  check_sundials(ARKStepSetMaxNumSteps(arkode, -1), "lifting the step limit");  // one step a call here
  // A law that bends needs a step a thousand times smaller at once; each failure takes a factor of some 3.
  constexpr int most_failures = 30;
  check_sundials(ARKStepSetMaxErrTestFails(arkode, most_failures), "setting how often a step may fail");
  if (!implicit_) return;
  // How fast Newton's method converges is not taken over from steps before: where that was fast, a law that
  // bends or a step of the inputs had one correction with an old matrix taken for the solution.
  constexpr double measured_anew = 1;
  check_sundials(ARKStepSetNonlinCRDown(arkode, measured_anew), "setting the rate of convergence");
  const std::string linsol = attach_linear_solver(SundialsPackage::arkode, arkode);
  // One Newton iteration is all that a linear system needs, where the linear solver is exact.
  const bool direct = linsol == "klu" || linsol == "cholmod";
  if (rhs_->traits().linear && direct)
    check_sundials(ARKStepSetLinear(arkode, 0), "saying that the system is linear");
}

void ArkodeRungeKutta::begin(double t, double /*end*/, std::span<const double> y,
                             std::span<const Instant> instants, bool smooth) {
  instants_ = instants;
  t_ = t;
  stop_ = t;
  if (smooth && has_history_) return;
  collect_counts();
  begin_anew(y);
  check_sundials(ARKStepReInit(arkode_.get(), explicit_part(), implicit_part(), t, y_.get()), "restart");
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
  if (flag < 0) return failure("ARKODE", t_, flag);
  stepped_ = true;
  if (plan_->track_inflow) add_inflow(begin, t_);
  show(y_.get());
  return {};
}

void ArkodeRungeKutta::record(ProbeHistory& history) {
  if (!std::exchange(stepped_, false)) return;
  record_taylor(t_, std::min(interpolant, order_ - 1), history);
}

void ArkodeRungeKutta::collect_counts() {
  if (!has_history_) return;
  PackageCounts counts;
  ARKStepGetNumSteps(arkode_.get(), &counts.steps);
  ARKStepGetNumErrTestFails(arkode_.get(), &counts.rejected);
  if (implicit_) {
    ARKStepGetNumLinSolvSetups(arkode_.get(), &counts.setups);
    ARKStepGetNumNonlinSolvIters(arkode_.get(), &counts.iterations);
  }
  take_counts(counts);
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
