#include "integrators/detail/implicit/sundials_propagator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

#include "integrators/detail/driver/run_guard.hpp"
#include "integrators/detail/gauss_points.hpp"
#include "integrators/detail/implicit/shifted_solver.hpp"
#include "integrators/detail/share_of_a_step.hpp"
#include "integrators/probe_history.hpp"

namespace superstep {
namespace {

SundialsPropagator& propagator_of(void* data) {
  return *static_cast<SundialsPropagator*>(static_cast<SundialsCallbackData*>(data)->integrator);
}

}  // namespace

void SundialsPropagator::prepare_vectors(Rhs& rhs, const Task& task) {
  rhs_ = &rhs;
  plan_ = task.plan;
  norm_.prepare(rhs, task.allowed);
  linear_solver_.reset();
  context_ = sundials::make_context();
  y_.reset(sundials::new_state_vector(rhs.reduction(), context_.get()));
  derivative_.reset(sundials::new_state_vector(rhs.reduction(), context_.get()));
  if (!y_ || !derivative_) throw std::bad_alloc();
  callback_data_ = {rhs_, this, nullptr, nullptr};
  state_.resize(rhs.size());
  has_history_ = false;
}

std::string SundialsPropagator::attach_linear_solver(SundialsPackage package, void* memory) {
  const bool automatic = linsol_ == "auto";
  const std::string linsol = automatic ? fastest_linear_solver(*rhs_) : linsol_;
  const std::string ordering = ordering_ == "auto" ? fastest_klu_ordering(*rhs_) : ordering_;
  if (automatic) choice_ = linsol == "klu" ? "linsol=klu,ordering=" + ordering : "linsol=" + linsol;
  linear_solver_ = make_sundials_linear_solver(linsol, ordering, *rhs_, y_.get(), context_.get());
  callback_data_.linear_solver = linear_solver_.get();
  linear_solver_->attach(package, memory);
  return linsol;
}

void SundialsPropagator::begin_anew(std::span<const double> y) {
  before_restart_ = counts_;
  std::copy(y.begin(), y.end(), sundials::entries(y_.get()).begin());
  std::copy(y.begin(), y.end(), state_.begin());
  has_history_ = false;
}

void SundialsPropagator::take_counts(const PackageCounts& counts) {
  evaluations_ = 0;
  counts_.steps = before_restart_.steps + static_cast<std::uint64_t>(counts.steps);
  counts_.rejected = before_restart_.rejected + static_cast<std::uint64_t>(counts.rejected);
  counts_.factorizations = before_restart_.factorizations + static_cast<std::uint64_t>(counts.setups);
  counts_.solves = before_restart_.solves + static_cast<std::uint64_t>(counts.iterations);
}

void SundialsPropagator::add_counts(Statistics& statistics) const {
  statistics.steps += counts_.steps;
  statistics.rejected += counts_.rejected;
  statistics.factorizations += counts_.factorizations;
  statistics.solves += counts_.solves;
  statistics.inflow += counts_.inflow;
}

void SundialsPropagator::show(N_Vector values) {
  const auto entries = sundials::entries(values);
  std::copy(entries.begin(), entries.end(), state_.begin());
}

/// The package's iteration may go round for ever, where numbers are so large or small that their quotients
/// are none.
bool SundialsPropagator::is_lost() noexcept {
  constexpr std::uint64_t most_evaluations = 100'000;  // in a step, which needs some hundreds
  lost_ = ++evaluations_ > most_evaluations;
  return lost_ || is_to_stop();
}

/// Processes that share a run agree between steps.
bool SundialsPropagator::is_to_stop() const noexcept {
  return !rhs_->reduction().among() && plan_->stop && plan_->stop->load(std::memory_order_relaxed);
}

Outcome SundialsPropagator::failure(const char* package, double t, int flag) const {
  if (is_to_stop()) return interrupted_at(t);
  if (callback_data_.thrown) std::rethrow_exception(callback_data_.thrown);
  if (linear_solver_ && linear_solver_->out_of_memory()) throw std::bad_alloc();
  if (lost_)
    return {Status::failed,
            fmt::format("{} finds no solution of its equations at t = {:.6g} s; take another method", package,
                        t)};
  return {Status::failed,
          fmt::format("{} stopped at t = {:.6g} s with flag {}: {}", package, t, flag, message_)};
}

void SundialsPropagator::add_inflow(double begin, double end) {
  counts_.inflow += gauss_integral(begin, end, [this](double t) {
    return differentiate(t, 0) ? rhs_->inflow(t, sundials::entries(derivative_.get())) : 0.0;
  });
}

void SundialsPropagator::record_taylor(double t, int order, ProbeHistory& history) {
  const auto& probes = plan_->probes;
  taylor_.resize(probes.size() * (static_cast<std::size_t>(order) + 1));
  double factorial = 1;
  for (int k = 0; k <= order; ++k) {
    if (k > 1) factorial *= k;
    if (!differentiate(t, k)) return;
    const auto values = sundials::entries(derivative_.get());
    for (std::size_t p = 0; p < probes.size(); ++p)
      taylor_[static_cast<std::size_t>(k) * probes.size() + p] = values[probes[p]] / factorial;
  }
  history.append(t, std::span<const double>(taylor_), order);
}

int SundialsPropagator::derivative(double t, N_Vector y, N_Vector ydot, void* data) noexcept {
  SundialsPropagator& method = propagator_of(data);
  if (method.is_lost()) return -1;
  auto& callback = *static_cast<SundialsCallbackData*>(data);
  return carried_out(callback, [&] {
    (*callback.rhs)(t, sundials::entries(y), sundials::entries(ydot));
    return 0;
  });
}

int SundialsPropagator::weights(N_Vector y, N_Vector inverse, void* data) noexcept {
  const SundialsPropagator& method = propagator_of(data);
  const double share = method.part_of_share_ * share_of_a_step(method.rtol_);
  const auto values = sundials::entries(y), out = sundials::entries(inverse);
  constexpr double roundings = 8 * std::numeric_limits<double>::epsilon();  // below them no step would pass
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double weight = method.norm_.weight(i);
    out[i] = weight > 0 ? 1 / std::max(share / weight, roundings * std::abs(values[i])) : 1e-30;
  }
  return 0;
}

void SundialsPropagator::keep_message(int /*code*/, const char* /*module*/, const char* function,
                                      char* message, void* self) noexcept {
  try {
    static_cast<SundialsPropagator*>(self)->message_ = fmt::format("{}: {}", function, message);
  } catch (...) {  // out of memory while reporting: the flag alone has to do
  }
}

}  // namespace superstep
