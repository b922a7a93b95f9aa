/// PETSc's time stepping: BDF and Rosenbrock-W methods as its users would run them, on the same right-hand
/// side, with an assembled Jacobian and with PETSc's own linear solvers. There where PETSc was found.
/// Source: Abhyankar et al. (2018), arXiv:1806.01437.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/shared_library.hpp"
#include "integrators/detail/error_norm.hpp"
#include "integrators/detail/gauss_points.hpp"
#include "integrators/detail/implicit/kept_jacobian.hpp"
#include "integrators/detail/petsc/ts_run.hpp"
#include "integrators/detail/share_of_a_step.hpp"
#include "integrators/detail/tolerance.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

struct Loaded {
  petsc::MakeRun* make_run = nullptr;
  petsc::WasBuiltWith* was_built_with = nullptr;
  std::string why_not;
};

Loaded load_petsc() {
  const LoadedModule module(petsc::module_file);
  if (!module.why_not().empty()) return {.why_not = module.why_not()};
  auto* const initialize = module.function<petsc::Initialize>(petsc::initialize_name);
  auto* const make_run = module.function<petsc::MakeRun>(petsc::make_run_name);
  auto* const was_built_with = module.function<petsc::WasBuiltWith>(petsc::was_built_with_name);
  if (!initialize || !make_run || !was_built_with)
    return {.why_not = "it is of another version of the program"};
  if (!(*initialize)()) return {.why_not = "it does not start"};
  return {make_run, was_built_with, ""};
}

/// Loaded and initialised once, where the first method is made: that is no part of any run's preparation.
const Loaded& loaded_petsc() {
  static const Loaded loaded = load_petsc();
  return loaded;
}

constexpr int bdf_fewest = 1, bdf_most = 6;

/// PETSc's L-stable Rosenbrock-W scheme of an order.
std::string scheme_of(int order) {
  switch (order) {
    case 2:
      return "2p";
    case 3:
      return "ra34pw2";
    case 4:
      return "4l";
    default:
      throw UsageError(fmt::format("petsc: order={} is not there with method=rosw; take 2, 3 or 4", order));
  }
}

class PetscTimeStepping final : public Propagator, private petsc::Problem {
 public:
  explicit PetscTimeStepping(const Options& options)
      : rtol_(options.number("rtol")),
        method_(options.word("method")),
        linsol_(options.word("linsol")),
        order_(options.integer("order")) {
    if (method_ == "rosw") (void)scheme_of(order_);
    (void)loaded_petsc();
  }

  void prepare(Rhs& rhs, const Task& task) override;
  void begin(double t, double end, std::span<const double> y, std::span<const Instant> instants,
             bool smooth) override;
  Outcome advance(std::size_t k) override;
  void record(ProbeHistory& history) override;

  [[nodiscard]] double rtol() const override { return rtol_; }
  [[nodiscard]] double time() const noexcept override { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept override { return state_; }
  [[nodiscard]] bool stops_on_the_way() const noexcept override { return true; }
  [[nodiscard]] std::string choice() const override { return choice_; }
  void reset_counts() override {
    before_ = run_ ? run_->counts() : petsc::Counts{};
    factorizations_ = 0;
    inflow_ = 0;
  }
  void add_counts(Statistics& statistics) const override;

 private:
  void residual(double t, const double* y, const double* slope, double* out) override;
  bool matrix(double t, const double* y, double shift, double* values) override;
  void take_pattern(petsc::Setup& setup);
  [[nodiscard]] petsc::Solver solver_for(const Rhs& rhs);
  [[nodiscard]] double share() const;
  [[nodiscard]] double first_step(double t, double end);
  void keep_slopes(double begin);

  double rtol_;
  std::string method_, linsol_, choice_;
  int order_;
  Rhs* rhs_ = nullptr;
  const Plan* plan_ = nullptr;
  ErrorNorm norm_;
  std::unique_ptr<KeptJacobian> jacobian_;
  std::vector<std::size_t> position_;  // [entries of the rows] of each in the columns of the Jacobian
  std::vector<double> mass_;           // [n] what an equation is multiplied with
  std::vector<std::int32_t> row_;      // [entries of the rows]
  double shift_ = 0;
  std::unique_ptr<petsc::Run> run_;
  petsc::Counts before_;
  std::uint64_t factorizations_ = 0;
  double inflow_ = 0;
  std::span<const Instant> instants_;
  double t_ = 0;
  std::vector<double> state_, slope_;           // at t_
  std::vector<double> earlier_, before_slope_;  // at the step's start, where somebody wants to look into it
  std::vector<double> between_, taylor_;        // room for states within the step, and for probes
  double step_ = 0;                             // s, the last one, of which nobody was told yet; 0 = none
};

/// Part of the tolerance that a step's local error may have: BDF of a fixed order takes more steps the
/// tighter they are, and their errors add up.
double PetscTimeStepping::share() const {
  constexpr double most = 0.2, fitted = 1.5;  // to random scenes (tests/audit)
  return method_ == "bdf" ? std::min(most, fitted * std::pow(rtol_, 1.0 / order_)) : share_of_a_step(rtol_);
}

void PetscTimeStepping::prepare(Rhs& rhs, const Task& task) {
  const auto& [make_run, was_built_with, why_not] = loaded_petsc();
  if (!make_run)
    throw Refused(
        fmt::format("PETSc cannot be loaded ({}); install libpetsc-real-dev and build again", why_not));
  if (linsol_ == "hypre" && !(*was_built_with)("hypre"))
    throw Refused(
        "PETSc was built without hypre, which linsol=hypre asks for; take linsol=cg or linsol=gmres, or "
        "build PETSc with it");
  run_.reset();
  rhs_ = &rhs;
  plan_ = task.plan;
  if (method_ == "rosw" && !rhs.traits().autonomous)
    throw Refused(
        "PETSc's Rosenbrock-W methods are for inputs that do not change in time; take method=bdf here");
  norm_.prepare(rhs, task.allowed);
  jacobian_ = std::make_unique<KeptJacobian>(rhs);
  shift_ = 0;
  petsc::Setup setup;
  setup.linear = rhs.traits().linear;
  setup.type = method_;
  setup.order = order_;
  if (method_ == "rosw") setup.scheme = scheme_of(order_);
  setup.solver = solver_for(rhs);
  for (const auto& field : rhs.fields())
    setup.field_end.push_back(static_cast<std::int32_t>(field.offset + field.count));
  take_pattern(setup);
  mass_.assign(rhs.size(), 1.0);
  if (rhs.traits().symmetric) std::copy_n(rhs.capacities().begin(), mass_.size(), mass_.begin());
  const double share = this->share();
  constexpr double unlimited = 1e30;  // of a field in which nothing may move
  for (std::size_t i = 0; i < rhs.size(); ++i)
    setup.allowed.push_back(norm_.weight(i) > 0 ? share / norm_.weight(i) : unlimited);
  setup.roundings = 8 * std::numeric_limits<double>::epsilon();
  // BDF predicts what it solves for; a stage of a Rosenbrock method begins with nothing.
  setup.residual = method_ == "bdf" ? 1e-5 : std::clamp(1e-2 * share * rtol_, 1e-12, 1e-5);
  run_.reset(make_run(setup, *this));
  before_ = {};
  state_.resize(rhs.size());
  slope_.resize(rhs.size());
  const bool looked_into = plan_->track_inflow || !plan_->probes.empty();
  earlier_.resize(looked_into ? rhs.size() : 0);
  before_slope_.resize(earlier_.size());
  between_.resize(plan_->track_inflow ? rhs.size() : 0);
  taylor_.resize(4 * plan_->probes.size());
}

/// Iterations where nothing is said: they were faster than both factorizations from a hundred unknowns on.
petsc::Solver PetscTimeStepping::solver_for(const Rhs& rhs) {
  const bool symmetric = rhs.traits().symmetric;
  std::string name = linsol_;
  if (name == "auto") {
    name = symmetric ? "cg" : "gmres";
    choice_ = "linsol=" + name;
  }
  if (name == "lu") return petsc::Solver::lu;
  if (name == "gmres") return petsc::Solver::gmres;
  if (name == "hypre") return symmetric ? petsc::Solver::multigrid_cg : petsc::Solver::multigrid_gmres;
  if (!symmetric)
    throw Refused("linsol=" + name + " needs a symmetric system; take linsol=gmres, or linsol=lu");
  return name == "cg" ? petsc::Solver::cg : petsc::Solver::cholesky;
}

/// Rows of the matrix, from the columns that the right-hand side knows.
void PetscTimeStepping::take_pattern(petsc::Setup& setup) {
  const auto& pattern = rhs_->pattern();
  const std::size_t n = rhs_->size(), entries = pattern.row.size();
  if (entries > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    throw Refused("PETSc was built with integers of four bytes: the network is too large for it");
  setup.row_begin.assign(n + 1, 0);
  for (const auto row : pattern.row) ++setup.row_begin[static_cast<std::size_t>(row) + 1];
  for (std::size_t i = 0; i < n; ++i) setup.row_begin[i + 1] += setup.row_begin[i];
  setup.column.resize(entries);
  position_.resize(entries);
  row_.resize(entries);
  std::vector<std::int32_t> next(setup.row_begin.begin(), setup.row_begin.end() - 1);
  for (std::size_t j = 0; j < n; ++j)
    for (auto k = pattern.column_begin[j]; k < pattern.column_begin[j + 1]; ++k) {
      const auto row = pattern.row[static_cast<std::size_t>(k)];
      const auto place = static_cast<std::size_t>(next[static_cast<std::size_t>(row)]++);
      setup.column[place] = static_cast<std::int32_t>(j);
      position_[place] = static_cast<std::size_t>(k);
      row_[place] = static_cast<std::int32_t>(row);
    }
}

void PetscTimeStepping::residual(double t, const double* y, const double* slope, double* out) {
  (*rhs_)(t, {y, mass_.size()}, {out, mass_.size()});
  for (std::size_t i = 0; i < mass_.size(); ++i) out[i] = mass_[i] * (slope[i] - out[i]);
}

bool PetscTimeStepping::matrix(double t, const double* y, double shift, double* values) {
  const bool kept = jacobian_->bring_to(t, {y, mass_.size()}, false);
  if (kept && shift == shift_) return false;
  shift_ = shift;
  ++factorizations_;
  const auto jacobian = jacobian_->values();
  const auto& diagonal = rhs_->pattern().diagonal;
  for (std::size_t k = 0; k < position_.size(); ++k) {
    const auto i = static_cast<std::size_t>(row_[k]);
    const bool on_diagonal = static_cast<std::int64_t>(position_[k]) == diagonal[i];
    values[k] = mass_[i] * ((on_diagonal ? shift : 0) - jacobian[position_[k]]);
  }
  return true;
}

/// In which the state moves by what a step may err by: the package begins with order one.
double PetscTimeStepping::first_step(double t, double end) {
  (*rhs_)(t, state_, slope_);
  const double rate = norm_.of([this](std::size_t i) { return slope_[i]; }) / share();
  return rate * (end - t) > 1 ? 1 / rate : end - t;
}

void PetscTimeStepping::begin(double t, double end, std::span<const double> y,
                              std::span<const Instant> instants, bool smooth) {
  instants_ = instants;
  const bool goes_on = smooth && t == t_ && step_ != 0;
  t_ = t;
  if (goes_on) return;
  std::copy(y.begin(), y.end(), state_.begin());
  step_ = 0;
  const double until = instants.empty() ? end : std::min(end, instants.back().t);
  if (!run_->begin(t, y, first_step(t, until))) throw std::runtime_error("PETSc: " + run_->message());
}

Outcome PetscTimeStepping::advance(std::size_t k) {
  const double begin = t_, end = instants_[k].t;
  if (!earlier_.empty()) {
    earlier_ = state_;
    (*rhs_)(begin, earlier_, before_slope_);
  }
  if (!run_->step(end))
    return {Status::failed, fmt::format("PETSc stopped at t = {:.6g} s: {}", begin, run_->message())};
  t_ = run_->time();
  run_->copy_state(state_);
  step_ = t_ - begin;
  if (!earlier_.empty()) keep_slopes(begin);
  return {};
}

/// What entered during a step, by Gauss points on the cubic through both ends of it.
void PetscTimeStepping::keep_slopes(double begin) {
  (*rhs_)(t_, state_, slope_);
  if (!plan_->track_inflow) return;
  inflow_ += gauss_integral(begin, t_, [this, begin](double t) {
    const double x = (t - begin) / step_, z = 1 - x;
    for (std::size_t i = 0; i < between_.size(); ++i)
      between_[i] = z * z * (1 + 2 * x) * earlier_[i] + x * x * (3 - 2 * x) * state_[i] +
                    step_ * x * z * (z * before_slope_[i] - x * slope_[i]);
    return rhs_->inflow(t, between_);
  });
}

void PetscTimeStepping::record(ProbeHistory& history) {
  if (!(step_ > 0)) return;
  const auto& probes = plan_->probes;
  for (std::size_t p = 0; p < probes.size(); ++p) {
    const std::size_t i = probes[p];
    const double change = (state_[i] - earlier_[i]) / step_, first = before_slope_[i], last = slope_[i];
    taylor_[p] = state_[i];
    taylor_[probes.size() + p] = last;
    taylor_[2 * probes.size() + p] = (first + 2 * last - 3 * change) / step_;
    taylor_[3 * probes.size() + p] = (first + last - 2 * change) / (step_ * step_);
  }
  history.append(t_, std::span<const double>(taylor_), 3);
}

void PetscTimeStepping::add_counts(Statistics& statistics) const {
  const petsc::Counts now = run_ ? run_->counts() : petsc::Counts{};
  statistics.steps += static_cast<std::uint64_t>(now.steps - before_.steps);
  statistics.rejected += static_cast<std::uint64_t>(now.rejected - before_.rejected);
  statistics.solves += static_cast<std::uint64_t>(now.iterations - before_.iterations);
  statistics.factorizations += factorizations_;
  statistics.inflow += inflow_;
}

}  // namespace

IntegratorEntry petsc_entry() {
  return {
      .name = "petsc",
      .summary = "PETSc TS, BDF and Rosenbrock-W methods",
      .source = "Abhyankar et al. (2018), arXiv:1806.01437",
      .colour = "#4d7c6f",
      .order = 0,
      .adaptive = true,
      .keys = {tolerance_key("1e-6"),
               {.name = "method",
                .type = OptionKey::Type::word,
                .words = {"bdf", "rosw"},
                .fallback = "bdf",
                .meaning = "backward differentiation, or Rosenbrock-W for inputs that do not change in time"},
               {.name = "order",
                .type = OptionKey::Type::integer,
                .min = bdf_fewest,
                .max = bdf_most,
                .fallback = "3",
                .meaning = "of bdf, fixed; of rosw 2, 3 or 4: its schemes 2p, ra34pw2, 4l"},
               {.name = "linsol",
                .type = OptionKey::Type::word,
                .words = {"auto", "lu", "cholesky", "cg", "gmres", "hypre"},
                .fallback = "auto",
                .meaning =
                    "sparse LU (KLU), sparse Cholesky (CHOLMOD), conjugate gradients or GMRES "
                    "behind incomplete factors, or either of them behind hypre's algebraic multigrid "
                    "(last bits may change with its version, threads and processes), all through PETSc"}},
      .examples = {"petsc:rtol=1e-7,method=rosw", "petsc:rtol=1e-7,order=4", "petsc:rtol=1e-8,linsol=cg",
                   "petsc:rtol=1e-6,linsol=lu", "petsc:rtol=1e-7,linsol=hypre"},
      .representatives = {"petsc:rtol=1e-3"},
      .ladder = joined({rtol_ladder("petsc", 2, 4, 2), rtol_ladder("petsc:order=5", 4, 8, 2),
                        rtol_ladder("petsc:method=rosw", 2, 4, 2),
                        rtol_ladder("petsc:method=rosw,order=4", 4, 6, 2)}),
      .make = [](const Options& options) { return std::make_unique<PetscTimeStepping>(options); }};
}

}  // namespace superstep
