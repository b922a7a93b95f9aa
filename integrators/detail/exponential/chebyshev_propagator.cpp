#include "integrators/detail/exponential/chebyshev_propagator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "integrators/detail/run_guard.hpp"

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
  // Truncation is bounded in the capacity-weighted norm. Where inputs drive small capacities its error may
  // lie in them alone; transients from a state spread it.
  const auto& facts = rhs().facts().fields.front();
  const bool driven = facts.has_sources || !facts.ambient.empty() || !rhs().traits().autonomous;
  const double norm = driven ? rms_over_weighted() : std::sqrt(rms_over_weighted());
  tolerance_ = (span() > 0 ? allowed() / span() : rtol()) / norm;
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
  for (std::size_t m = 0; m < outputs.size(); ++m) {
    coefficients_[m] = exponential_coefficients(outputs[m].elapsed * radius_ / 2, tolerance_,
                                                scale.over(outputs[m].elapsed));
    if (plan().track_inflow) integrals_[m] = integrated_coefficients(coefficients_[m]);
    terms_ = std::max(terms_, coefficients_[m].size());
    std::fill(outputs[m].state.begin(), outputs[m].state.end(), 0.0);
    std::fill(outputs[m].probes.begin(), outputs[m].probes.end(), 0.0);
    outputs[m].inflow = 0;
  }
  if (radius_ == 0) return no_exchange(outputs);
  std::copy(origin().begin(), origin().end(), u_.begin());
  add_probes(0, u_.data(), 0, u_.size());
  if (terms_ == 1) add_pair(0, u_.data(), u_.data(), 0, u_.size());

  std::array<ChainedStage, longest_chain> links;
  // Time obeys the recurrence as an entry with rate 1 would.
  const auto time_of = [&](std::size_t k) {
    return now() + 2 * static_cast<double>(k) * static_cast<double>(k) / radius_;
  };
  for (std::size_t k = 1; k < terms_; k += longest_chain) {  // U_k from U_{k-1} and U_{k-2}
    const auto chain = std::span(links).first(std::min(longest_chain, terms_ - k));
    for (std::size_t j = 0; j < chain.size(); ++j) {
      const Stage first{.y1 = u_.data(), .a = 1, .d = 2 / radius_};
      const Stage later{.y1 = u_.data(), .a = 2, .d = 4 / radius_, .y2 = next_.data(), .b = -1};
      chain[j] = {.t = time_of(k + j - 1), .stage = k + j == 1 ? first : later, .out = next_.data()};
      std::swap(u_, next_);
    }
    chain_ = chain;
    chain_begin_ = k;
    rhs().chain(chain, plan().track_inflow, this);
    for (std::size_t j = 0; j < chain.size() && plan().track_inflow; ++j)
      add_inflow(k + j - 1, chain[j].inflow);
    if (stop_requested()) return interrupted_at(now());
  }
  if (plan().track_inflow) add_inflow(terms_ - 1, rhs().inflow(time_of(terms_ - 1), u_));
  count_terms(terms_);
  constexpr double roundings_of_a_term = 4 * std::numeric_limits<double>::epsilon();
  add_bound(tolerance_ * rms_over_weighted() +
            static_cast<double>(terms_) * roundings_of_a_term * magnitude());
  return {};
}

}  // namespace superstep
