#include "integrators/detail/exponential/lanczos_propagator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/parallel.hpp"
#include "integrators/detail/exponential/chebyshev_exponential.hpp"
#include "integrators/detail/run_guard.hpp"

namespace superstep {
namespace {

constexpr std::size_t most_vectors = 20'000;
constexpr std::size_t first_check = 12;
constexpr double check_growth = 1.15;
/// Of the mean capacity to the smallest. Vectors are normed and made orthogonal in the capacity norm:
/// roundings of 1e-16 there are errors of 1e-16 times the root of this in the values of the smallest nodes.
constexpr double widest_capacities = 1e16;

}  // namespace

TridiagonalResponse tridiagonal_response(std::span<const double> alpha, std::span<const double> beta,
                                         double t, double tolerance) {
  const std::size_t m = alpha.size();
  double radius = 0;  // Gershgorin
  for (std::size_t j = 0; j < m; ++j)
    radius = std::max(radius, alpha[j] + (j > 0 ? beta[j - 1] : 0) + (j + 1 < m ? beta[j] : 0));
  TridiagonalResponse out{std::vector<double>(m, 0.0), std::vector<double>(m, 0.0)};
  if (!(radius > 0)) {
    out.value[0] = t;
    out.integral[0] = t * t / 2;
    return out;
  }
  // y' = e_1 - T y from 0: a rate of length 1, and results up to t.
  const auto c = exponential_coefficients(t * radius / 2, tolerance, {.by_rate = true, .rate = 1});
  const auto d = integrated_coefficients(c);
  // The affine Chebyshev recurrence of chebyshev_exponential.hpp on y' = e_1 - T y.
  std::vector<double> before(m, 0.0), now(m, 0.0);
  const auto derivative = [&](const std::vector<double>& y, std::size_t j) {
    return (j == 0 ? 1.0 : 0.0) - alpha[j] * y[j] - (j > 0 ? beta[j - 1] * y[j - 1] : 0) -
           (j + 1 < m ? beta[j] * y[j + 1] : 0);
  };
  now[0] = 2 / radius;
  for (std::size_t k = 1; k < c.size(); ++k) {
    for (std::size_t j = 0; j < m; ++j) {
      out.value[j] += c[k] * now[j];
      out.integral[j] += 2 / radius * d[k] * now[j];
    }
    for (std::size_t j = 0; j < m; ++j) before[j] = 2 * now[j] - before[j] + 4 / radius * derivative(now, j);
    std::swap(before, now);
  }
  return out;
}

void LanczosPropagator::allocate() {
  if (!rhs().traits().autonomous)
    throw Refused("basis=lanczos is for constant inputs; leave it out where they change in time");
  const auto capacity = rhs().capacities();
  double total = 0, smallest = std::numeric_limits<double>::infinity();
  for (const double c : capacity) {
    total += c;
    smallest = std::min(smallest, c);
  }
  if (total / static_cast<double>(capacity.size()) > widest_capacities * smallest)
    throw Refused(
        fmt::format("basis=lanczos: the smallest capacity is {:.1e} of the mean, and below {:.0e} its values "
                    "drown in rounding; use basis=chebyshev",
                    smallest * static_cast<double>(capacity.size()) / total, 1 / widest_capacities));
  for (auto* v : {&v_, &previous_, &w_}) v->resize(rhs().size());
}

double LanczosPropagator::dot(const std::vector<double>& a, const std::vector<double>& b) const {
  const auto capacity = rhs().capacities();
  return rhs().reduction().sum([&](std::size_t i) { return capacity[i] * a[i] * b[i]; });
}

void LanczosPropagator::begin_space() {
  rhs()(now(), origin(), v_);
  length_ = std::sqrt(dot(v_, v_));
  if (length_ > 0)
    for (double& entry : v_) entry /= length_;
  std::fill(previous_.begin(), previous_.end(), 0.0);
}

bool LanczosPropagator::next_vector(std::size_t j) {
  const double coupling = j > 0 ? beta_[j - 1] : 0;
  rhs().linear_stage({.y1 = v_.data(), .a = 0, .d = -1, .y2 = previous_.data(), .b = -coupling}, w_);
  if (j == alpha_.size()) alpha_.push_back(dot(v_, w_));
  for_each_entry(w_.size(), [&](std::size_t i) { w_[i] -= alpha_[j] * v_[i]; });
  if (j == beta_.size()) beta_.push_back(std::sqrt(dot(w_, w_)));
  if (!(beta_[j] > 1e-14 * radius())) return false;
  for_each_entry(w_.size(), [&](std::size_t i) { w_[i] /= beta_[j]; });
  std::swap(previous_, v_);
  std::swap(v_, w_);
  return true;
}

double LanczosPropagator::allowed_error() const {
  const auto capacity = rhs().capacities();
  const double total = rhs().reduction().sum([&](std::size_t i) { return capacity[i]; });
  return tolerance() * span() * std::sqrt(total);
}

/// The residual of the projected solution u is beta_m |f_0| u_m(s) v_{m+1}. The components of u keep their
/// signs for all times, so that the integral of |u_m| is that of u_m.
double LanczosPropagator::precision_of_small_solution(double elapsed) const {
  constexpr double part = 0.01;
  return std::clamp(part * allowed_error() / (length_ * elapsed), 1e-18, 1e-3);
}

bool LanczosPropagator::accurate(double elapsed) const {
  const std::size_t m = alpha_.size();
  const double scale = length_ * beta_.back(), wanted = allowed_error() / scale;
  const double precision = std::clamp(0.1 * wanted / (elapsed * elapsed), 1e-18, 1e-3);
  const auto u = tridiagonal_response(alpha_, std::span(beta_).first(m - 1), elapsed, precision);
  constexpr double safety = 0.5;  // the small solution has errors, too
  return std::abs(u.integral.back()) <= safety * wanted;
}

Outcome LanczosPropagator::propagate(std::span<Output> outputs) {
  if (radius() == 0) return no_exchange(outputs);
  alpha_.clear();
  beta_.clear();
  begin_space();
  double check_at = first_check;
  for (bool more = length_ > 0; more;) {
    more = next_vector(alpha_.size());
    if (more && static_cast<double>(alpha_.size()) >= check_at) {
      check_at *= check_growth;
      more = !accurate(outputs.back().elapsed);
    }
    if (stop_requested()) return interrupted_at(now());
    if (alpha_.size() >= most_vectors)
      return {Status::failed,
              fmt::format("Lanczos did not reach the tolerance in {} products; use basis=chebyshev",
                          most_vectors)};
  }
  const std::size_t m = alpha_.size();
  std::vector<TridiagonalResponse> responses;
  const double inflow = rhs().inflow(now(), origin());
  for (auto& output : outputs) {
    if (m > 0)
      responses.push_back(tridiagonal_response(alpha_, std::span(beta_).first(m - 1), output.elapsed,
                                               precision_of_small_solution(output.elapsed)));
    std::copy_n(origin().begin(), output.state.size(), output.state.begin());
    for (std::size_t p = 0; p < plan().probes.size(); ++p) output.probes[p] = origin()[plan().probes[p]];
    output.inflow = plan().track_inflow ? output.elapsed * inflow : 0;
  }
  begin_space();
  for (std::size_t j = 0; j < m; ++j) {
    const double inflow_change = plan().track_inflow ? rhs().linear_inflow(v_) : 0;
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      const double factor = length_ * responses[k].value[j];
      for (std::size_t p = 0; p < plan().probes.size(); ++p)
        outputs[k].probes[p] += factor * v_[plan().probes[p]];
      for_each_entry(outputs[k].state.size(), [&](std::size_t i) { outputs[k].state[i] += factor * v_[i]; });
      if (plan().track_inflow) outputs[k].inflow += length_ * responses[k].integral[j] * inflow_change;
    }
    if (j + 1 < m) next_vector(j);
  }
  count_terms(2 * m);
  constexpr double roundings_of_a_term = 4 * std::numeric_limits<double>::epsilon();
  count_rounding(2 * static_cast<double>(m) * roundings_of_a_term * (1 + magnitude()));
  return {};
}

}  // namespace superstep
