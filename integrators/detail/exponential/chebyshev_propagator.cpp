#include "integrators/detail/exponential/chebyshev_propagator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/parallel.hpp"
#include "integrators/detail/driver/run_guard.hpp"

namespace superstep {
namespace {

double coefficient(const std::vector<double>& list, std::size_t k) noexcept {
  return k < list.size() ? list[k] : 0.0;
}

}  // namespace

void ChebyshevPropagator::allocate() {
  u_.assign(rhs().size(), 0.0);
  next_.resize(rhs().size());
  SpectralRadius radius;
  radius.prepare(rhs(), {});
  radius_ = radius.at(0, u_);
  // Truncation is bounded in the capacity-weighted norm, and its error may lie in the smallest capacities
  // alone. Roundings are no reason to truncate earlier: that would save a term or two.
  tolerance_ = part_allowed() / rms_over_weighted();
}

void ChebyshevPropagator::add_inflow(std::size_t k, double inflow) {
  for (std::size_t m = 0; m < outputs_.size(); ++m)
    if (k < integrals_[m].size()) outputs_[m].inflow += 2 / radius_ * integrals_[m][k] * inflow;
}

void ChebyshevPropagator::add_probes(std::size_t k, const double* u, std::size_t first, std::size_t last) {
  for (std::size_t p = 0; p < plan().probes.size(); ++p) {
    const std::size_t probe = plan().probes[p];
    if (probe < first || probe >= last) continue;
    for (std::size_t m = 0; m < outputs_.size(); ++m)
      outputs_[m].probes[p] += coefficient(coefficients_[m], k) * u[probe];
  }
}

/// Terms k and k+1 at once: half the traffic of adding them one by one.
void ChebyshevPropagator::add_pair(std::size_t k, const double* u, const double* next, std::size_t first,
                                   std::size_t last) {
  for (std::size_t m = 0; m < outputs_.size(); ++m) {
    if (outputs_[m].state.empty() || k >= coefficients_[m].size()) continue;
    const double a = coefficients_[m][k], b = coefficient(coefficients_[m], k + 1);
    double* state = outputs_[m].state.data();
    for (std::size_t i = first; i < last; ++i) state[i] += a * u[i] + b * next[i];
  }
}

/// U_k is there in some entries, and U_{k-1} still.
void ChebyshevPropagator::entries_done(std::size_t stage, std::size_t first, std::size_t last) {
  const std::size_t k = chain_begin_ + stage;
  const double *u = chain_[stage].out, *before = chain_[stage].stage.y1;
  add_probes(k, u, first, last);
  if (k % 2 == 1) add_pair(k - 1, before, u, first, last);
  if (k % 2 == 0 && k + 1 == terms_) add_pair(k, u, u, first, last);
}

Outcome ChebyshevPropagator::propagate(std::span<Output> outputs) {
  outputs_ = outputs;
  terms_ = 1;
  coefficients_.resize(std::max(coefficients_.size(), outputs.size()));
  integrals_.resize(coefficients_.size());
  const ExpansionScale scale =
      find_expansion_scale(rhs(), now(), outputs.back().elapsed, origin(), span(), u_, next_);
  double left_out = 0;
  for (std::size_t m = 0; m < outputs.size(); ++m) {
    TruncatedSeries series =
        exponential_series(outputs[m].elapsed * radius_ / 2, tolerance_, scale.over(outputs[m].elapsed));
    left_out = std::max(left_out, series.left_out);
    coefficients_[m] = std::move(series.c);
    if (plan().track_inflow) integrals_[m] = integrated_coefficients(coefficients_[m]);
    terms_ = std::max(terms_, coefficients_[m].size());
    std::fill(outputs[m].state.begin(), outputs[m].state.end(), 0.0);
    std::fill(outputs[m].probes.begin(), outputs[m].probes.end(), 0.0);
    outputs[m].inflow = 0;
  }
  if (radius_ == 0) return no_exchange(outputs);
  count_terms(terms_);
  add_bound(left_out * rms_over_weighted(), 0);
  const double rounding = rounding_of_terms(1 + magnitude(), scale);
  constexpr double never_mind = 1e-11;  // of a whole run
  if (rounding > std::max(tolerance_, never_mind * share_of_run())) return expand_change();
  add_bound(0, rounding);
  return expand_state();
}

namespace {

/// What the rounding of each term adds to U_k, over the size of the terms. What it adds to one term it goes
/// on adding to later ones: worst by a factor k in a mode that hardly decays. Roundings of many terms add up
/// to less than their number, and to more than a walk at random, since they are alike where terms hardly
/// change: the exponent is above what was needed on two thousand networks, t*rho up to 1e9, against sixty
/// digits (tests/audit, --bounds).
double roundings_by_term(std::size_t k) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon(), of_a_term = 4, alike = 0.75;
  const double terms = 1 + static_cast<double>(k);
  return epsilon * terms * (of_a_term + std::pow(terms, alike));
}

}  // namespace

/// Known beforehand, for U_k as they are.
///   size  of the state, in spans
///
/// U_k moves from U_0 by at most what its inputs do to an entry of rate 0, and in a mode of rate lambda by at
/// most min(2/lambda, 2 k^2/rho) times a constant input, where the state moves by (1 - exp(-lambda
/// t))/lambda: by 4 max(1, k^2/z) times as much, and that is at most a span.
double ChebyshevPropagator::rounding_of_terms(double size, const ExpansionScale& scale) const {
  const bool constant = rhs().traits().autonomous;
  double worst = 0;
  for (std::size_t m = 0; m < outputs_.size(); ++m) {
    const double z = outputs_[m].elapsed * radius_ / 2;
    double sum = 0;
    for (std::size_t k = 0; k < coefficients_[m].size(); ++k) {
      const double time = time_of(k);
      double moved = scale.by_rate ? time * (scale.rate + time / 2 * scale.turn) : 0;
      if (constant) moved = std::min(moved, 4 * std::max(1.0, static_cast<double>(k * k) / z));
      sum += coefficients_[m][k] * (size + moved) * roundings_by_term(k);
    }
    worst = std::max(worst, sum);
  }
  return worst;
}

/// U_k as they are: every term one fused sweep, many in a row.
Outcome ChebyshevPropagator::expand_state() {
  std::copy(origin().begin(), origin().end(), u_.begin());
  add_probes(0, u_.data(), 0, u_.size());
  if (terms_ == 1) add_pair(0, u_.data(), u_.data(), 0, u_.size());

  std::array<ChainedStage, longest_chain> links;
  for (std::size_t k = 1; k < terms_; k += longest_chain) {  // U_k from U_{k-1} and U_{k-2}
    const auto chain = std::span(links).first(std::min(longest_chain, terms_ - k));
    for (std::size_t j = 0; j < chain.size(); ++j) {
      const Stage first{.y1 = u_.data(), .a = 1, .d = 2 / radius_};
      const Stage later{.y1 = u_.data(), .a = 2, .d = 4 / radius_, .y2 = next_.data(), .b = -1};
      chain[j] = {.t = now() + time_of(k + j - 1), .stage = k + j == 1 ? first : later, .out = next_.data()};
      std::swap(u_, next_);
    }
    chain_ = chain;
    chain_begin_ = k;
    rhs().chain(chain, plan().track_inflow, this);
    for (std::size_t j = 0; j < chain.size() && plan().track_inflow; ++j)
      add_inflow(k + j - 1, chain[j].inflow);
    if (stop_requested()) return interrupted_at(now());
  }
  if (plan().track_inflow) add_inflow(terms_ - 1, rhs().inflow(now() + time_of(terms_ - 1), u_));
  return {};
}

/// For more digits than that leaves: W_k = U_k - U_0, which lose none to what all nodes have in common, and
/// whose sizes are looked at. f(t, U_0 + W) = J W + f(t, U_0), and that is linear in time.
Outcome ChebyshevPropagator::expand_change() {
  const std::size_t n = origin().size();
  const bool constant = rhs().traits().autonomous;
  const double elapsed = outputs_.back().elapsed;
  for (auto* vector : {&rate_, &turn_, &drive_}) vector->resize(n);
  rhs()(now(), origin(), rate_);
  drive_ = rate_;
  if (!constant) {
    rhs()(now() + elapsed, origin(), turn_);
    for_each_entry(n, [&](std::size_t i) { turn_[i] = (turn_[i] - rate_[i]) / elapsed; });
  }
  const double inflow = plan().track_inflow ? rhs().inflow(now(), origin()) : 0;
  const double inflow_turn =
      constant || !plan().track_inflow ? 0 : (rhs().inflow(now() + elapsed, origin()) - inflow) / elapsed;
  std::fill(u_.begin(), u_.end(), 0.0);
  std::fill(next_.begin(), next_.end(), 0.0);
  std::vector<double> rounding(outputs_.size(), 0.0);
  double largest = 1;  // of the W_k so far, rms in spans
  const auto rms = [&](const StateVector& v) {
    const double squares = rhs().reduction().sum([&](std::size_t i) { return v[i] * v[i]; });
    return std::sqrt(squares / static_cast<double>(rhs().reduction().total()));
  };
  for (std::size_t k = 0; k < terms_; ++k) {
    if (k > 0) {
      const double t = time_of(k - 1), factor = (k == 1 ? 2 : 4) / radius_;
      if (!constant) for_each_entry(n, [&](std::size_t i) { drive_[i] = rate_[i] + t * turn_[i]; });
      const Stage stage{.y1 = u_.data(),
                        .a = k == 1 ? 1.0 : 2.0,
                        .d = factor,
                        .y2 = next_.data(),
                        .b = k == 1 ? 0.0 : -1.0,
                        .f0 = drive_.data(),
                        .e = factor};
      rhs().linear_stage(stage, next_);
      std::swap(u_, next_);
    }
    if (span() > 0) largest = std::max(largest, rms(u_) / span());
    for (std::size_t m = 0; m < outputs_.size(); ++m)
      rounding[m] += coefficient(coefficients_[m], k) * largest * roundings_by_term(k);
    add_probes(k, u_.data(), 0, n);
    for_ranges(n, n, [&](std::size_t first, std::size_t last) {
      if (k % 2 == 1) add_pair(k - 1, next_.data(), u_.data(), first, last);
      if (k % 2 == 0 && k + 1 == terms_) add_pair(k, u_.data(), u_.data(), first, last);
    });
    if (plan().track_inflow) add_inflow(k, inflow + time_of(k) * inflow_turn + rhs().linear_inflow(u_));
    if (stop_requested()) return interrupted_at(now());
  }
  const double stored =
      std::numeric_limits<double>::epsilon() * magnitude();  // with what all nodes have in common
  add_bound(0, *std::max_element(rounding.begin(), rounding.end()) + stored);
  for (auto& output : outputs_) {
    for_each_entry(output.state.size(), [&](std::size_t i) { output.state[i] += origin()[i]; });
    for (std::size_t p = 0; p < plan().probes.size(); ++p) output.probes[p] += origin()[plan().probes[p]];
  }
  return {};
}

}  // namespace superstep
