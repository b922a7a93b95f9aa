#include "integrators/detail/chebyshev_propagator.hpp"

#include <algorithm>
#include <utility>

#include "core/parallel.hpp"
#include "integrators/detail/chebyshev_exponential.hpp"

namespace superstep {
namespace {

constexpr std::size_t stop_check_every = 16;  // sweeps

double coefficient(const std::vector<double>& list, std::size_t k) noexcept {
  return k < list.size() ? list[k] : 0.0;
}

}  // namespace

void ChebyshevPropagator::allocate(std::size_t outputs) {
  u_.resize(rhs().size());
  next_.resize(rhs().size());
  coefficients_.resize(outputs);
  integrals_.resize(outputs);
}

/// What every term adds besides the state: probes and inflow.
void ChebyshevPropagator::collect(std::span<Output> outputs, std::size_t k, std::span<const double> u) {
  const double inflow = plan().track_inflow ? rhs().inflow(now(), u) : 0;
  for (std::size_t m = 0; m < outputs.size(); ++m) {
    if (k >= coefficients_[m].size()) continue;
    for (std::size_t p = 0; p < plan().probes.size(); ++p)
      outputs[m].probes[p] += coefficients_[m][k] * u[plan().probes[p]];
    if (plan().track_inflow) outputs[m].inflow += 2 / radius() * integrals_[m][k] * inflow;
  }
}

/// Terms k and k+1 at once: half the traffic of adding them one by one.
void ChebyshevPropagator::add_pair(std::span<Output> outputs, std::size_t k, std::span<const double> u,
                                   std::span<const double> next) {
  for (std::size_t m = 0; m < outputs.size(); ++m) {
    if (!outputs[m].full || k >= coefficients_[m].size()) continue;
    const double a = coefficients_[m][k], b = coefficient(coefficients_[m], k + 1);
    double* state = outputs[m].state.data();
    for_each_entry(u.size(), [&](std::size_t i) { state[i] += a * u[i] + b * next[i]; });
  }
}

Outcome ChebyshevPropagator::propagate(std::span<Output> outputs) {
  std::size_t terms = 0;
  const bool driven = rhs().source_rate(0) > 0;
  for (std::size_t m = 0; m < outputs.size(); ++m) {
    coefficients_[m] = exponential_coefficients(outputs[m].elapsed * radius() / 2, rtol_, driven);
    if (plan().track_inflow) integrals_[m] = integrated_coefficients(coefficients_[m]);
    terms = std::max(terms, coefficients_[m].size());
    std::fill(outputs[m].state.begin(), outputs[m].state.end(), 0.0);
    std::fill(outputs[m].probes.begin(), outputs[m].probes.end(), 0.0);
    outputs[m].inflow = 0;
  }
  if (radius() == 0) return no_exchange(outputs);
  std::copy(origin().begin(), origin().end(), u_.begin());
  // Terms come in pairs (k, k+1): u_ holds U_k, next_ holds U_{k+1}.
  rhs().stage(now(), {.y1 = u_.data(), .a = 1, .d = 2 / radius()}, next_);
  for (std::size_t k = 0; k < terms; k += 2) {
    collect(outputs, k, u_);
    collect(outputs, k + 1, next_);
    add_pair(outputs, k, u_, next_);
    if (k + 2 >= terms) break;
    rhs().stage(now(), {.y1 = next_.data(), .a = 2, .d = 4 / radius(), .y2 = u_.data(), .b = -1}, u_);
    if (k + 3 < terms)
      rhs().stage(now(), {.y1 = u_.data(), .a = 2, .d = 4 / radius(), .y2 = next_.data(), .b = -1}, next_);
    if (k % stop_check_every == 0 && stop_requested()) return interrupted_at(now());
  }
  statistics_.max_stages = std::max(statistics_.max_stages, static_cast<int>(terms));
  return {};
}

}  // namespace superstep
