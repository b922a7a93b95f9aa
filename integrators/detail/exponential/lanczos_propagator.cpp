#include "integrators/detail/exponential/lanczos_propagator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/parallel.hpp"
#include "integrators/detail/driver/run_guard.hpp"
#include "integrators/detail/krylov/tridiagonal_response.hpp"

namespace superstep {
namespace {

constexpr std::size_t fewest_vectors = 8, most_vectors_ever = 40'000;

}  // namespace

void LanczosPropagator::allocate() {
  const auto storage = LanczosSpace::storage_for(part_allowed());
  const double vector = static_cast<double>(rhs().reduction().total() * static_cast<std::size_t>(storage));
  const double fit = std::min(memory_ / std::max(vector, 1.0), static_cast<double>(most_vectors_ever));
  if (fit < fewest_vectors)
    throw Refused(
        fmt::format("basis=lanczos: {:.0f} MiB hold {:.0f} vectors, too few; give it more memory, "
                    "or use basis=chebyshev",
                    memory_ / 0x1p20, fit));
  most_vectors_ = static_cast<std::size_t>(fit);
  start_.resize(rhs().size());
  space_.emplace(rhs(), storage, recent_);
}

void LanczosPropagator::start_over() {
  open_ = false;
  offset_ = start_inflow_ = 0;
  unspent_ = allowed();
  covered_ = false;
  std::copy(origin().begin(), origin().end(), start_.begin());
}

void LanczosPropagator::open_space() {
  open_ = true;
  reported_ = {};
  const double t = now() + offset_;
  space_->open(stretch() - offset_, plan().track_inflow,
               [&](std::span<double> first) { rhs()(t, start_, first); });
  rate_of_inflow_ = plan().track_inflow ? rhs().inflow(t, start_) : 0;
}

/// Longest time that the present space covers, of `longest` to the end, for its share of the error.
double LanczosPropagator::time_covered(double longest) const {
  double low = 0, high = longest;
  constexpr int bisections = 20;
  for (int k = 0; k < bisections; ++k) {
    const double middle = 0.5 * (low + high);
    (estimate_at(middle) <= unspent_ * middle / longest ? low : high) = middle;
  }
  return low;
}

/// Coefficients of unit vectors without those at the end that add less than a thousandth of the tolerance:
/// early instants need fewer vectors than the last one.
///   dropped  becomes at least what they add [K or V, rms]
std::vector<double> LanczosPropagator::significant(std::vector<double> coefficients, double& dropped) const {
  constexpr double insignificant = 1e-3;
  double square = 0;
  while (!coefficients.empty()) {
    square += coefficients.back() * coefficients.back();
    const double all = space_->length() * std::sqrt(square) * rms_over_norm();
    if (all > insignificant * allowed()) break;
    dropped = std::max(dropped, all);
    coefficients.pop_back();
  }
  return coefficients;
}

/// States, probes and inflows at instants that the space covers.
void LanczosPropagator::evaluate(std::span<Output> outputs) {
  std::vector<double> times;
  for (const auto& output : outputs) times.push_back(output.elapsed - offset_);
  const std::size_t m = space_->dimension();
  auto responses = tridiagonal_responses(space_->alpha(), space_->beta().first(m > 0 ? m - 1 : 0), times);
  std::vector<std::vector<double>> factors;
  std::vector<std::span<double>> states;
  double dropped = 0;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    Output& output = outputs[k];
    output.inflow = start_inflow_ + times[k] * rate_of_inflow_;
    for (std::size_t j = 0; j < space_->inflow().size(); ++j)
      output.inflow += space_->length() * responses[k].integral[j] * space_->inflow()[j];
    factors.push_back(significant(std::move(responses[k].value), dropped));
    for (double& factor : factors[k]) factor *= space_->length();
    for (std::size_t p = 0; p < plan().probes.size(); ++p)
      output.probes[p] = start_[plan().probes[p]] + space_->entry(plan().probes[p], factors[k]);
    std::copy_n(start_.begin(), output.state.size(), output.state.begin());
    states.push_back(output.state);
  }
  // Each product rounds by some epsilons of rho, which then act as the residual does; kept vectors and the
  // small solution are rounded.
  double sum = 0, kept = 0;
  for (const double integral : responses.back().integral) sum += std::abs(integral);
  for (const auto& of_output : factors) {
    double all = 0;
    for (const double factor : of_output) all += std::abs(factor);
    kept = std::max(kept, all * space_->rounding());
  }
  constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();
  const double rounding = (space_->length() * (roundings * rhs().spectral_bound(now(), start_) * sum +
                                               response_error * times.back()) +
                           kept) *
                          rms_over_norm();
  space_->add_to(states, std::move(factors));
  const double stored = std::numeric_limits<double>::epsilon() * magnitude() * span();
  add_growth({bound_at(times.back()) + dropped, rounding + stored}, reported_);
}

/// A new space from a time [s since the origin] that this one covers.
Outcome LanczosPropagator::restart_at(double covered, double error) {
  if (!(covered > offset_))
    return {Status::failed, fmt::format("{} Lanczos vectors do not cover any time; give them more memory, or "
                                        "use basis=chebyshev",
                                        space_->dimension())};
  StateVector state(start_.size());
  Output end{.elapsed = covered, .state = state, .probes = std::vector<double>(plan().probes.size())};
  evaluate({&end, 1});
  unspent_ -= error;
  start_ = std::move(state);
  offset_ = covered;
  start_inflow_ = end.inflow;
  open_ = false;
  return {};
}

/// Adds vectors until the space covers `elapsed` or is as large as it may be.
Outcome LanczosPropagator::grow(double elapsed) {
  const auto growth = space_->grow(elapsed, unspent_, rms_over_norm(), {}, most_vectors_, plan().stop);
  covered_ = growth == LanczosSpace::Growth::covers;
  count_terms(space_->dimension());
  return growth == LanczosSpace::Growth::stopped ? interrupted_at(now() + offset_) : Outcome{};
}

Outcome LanczosPropagator::propagate(std::span<Output> outputs) {
  if (rhs().spectral_bound(now(), origin()) == 0) return no_exchange(outputs);
  while (true) {
    if (!open_) open_space();
    const double remaining = outputs.back().elapsed - offset_;
    if (Outcome outcome = grow(remaining); !outcome.ok()) return outcome;
    if (covered_) break;
    const double whole = stretch() - offset_, time = time_covered(std::max(whole, remaining));
    const double covered = offset_ + time;
    const auto end = std::find_if(outputs.begin(), outputs.end(),
                                  [&](const Output& output) { return output.elapsed > covered; });
    const auto done = static_cast<std::size_t>(end - outputs.begin());
    if (done > 0) evaluate(outputs.first(done));
    outputs = outputs.subspan(done);
    if (Outcome outcome = restart_at(covered, unspent_ * time / whole); !outcome.ok()) return outcome;
  }
  evaluate(outputs);
  return {};
}

}  // namespace superstep
