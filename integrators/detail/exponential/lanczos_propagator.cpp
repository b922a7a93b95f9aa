#include "integrators/detail/exponential/lanczos_propagator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/parallel.hpp"
#include "integrators/detail/exponential/tridiagonal_response.hpp"
#include "integrators/detail/run_guard.hpp"

namespace superstep {
namespace {

constexpr std::size_t fewest_vectors = 8, most_vectors_ever = 40'000;
constexpr std::size_t stretch_of_entries = 1024;  // stays in the first cache while vectors are added up

}  // namespace

void LanczosPropagator::allocate() {
  if (!rhs().traits().autonomous)
    throw Refused("basis=lanczos is for constant inputs; leave it out where they change in time");
  const double vector = static_cast<double>(rhs().size() * sizeof(double));
  const double fit = std::min(memory_ / std::max(vector, 1.0), static_cast<double>(most_vectors_ever));
  if (fit < fewest_vectors)
    throw Refused(
        fmt::format("basis=lanczos: {:.0f} MiB hold {:.0f} vectors, too few; give it more memory, "
                    "or use basis=chebyshev",
                    memory_ / 0x1p20, fit));
  most_vectors_ = static_cast<std::size_t>(fit);
  start_.resize(rhs().size());
  basis_ = VectorStore(rhs().size());
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
  reported_ = 0;
  norm_.clear();
  alpha_.clear();
  inflow_.clear();
  bound_ = ResidualBound(stretch() - offset_);
  const auto rate = basis_.at(0);
  rhs()(now() + offset_, start_, rate);
  norm_.push_back(std::sqrt(dot(rate, rate)));
  rate_of_inflow_ = plan().track_inflow ? rhs().inflow(now() + offset_, start_) : 0;
}

/// One sweep: v_{j+1} from v_j and v_{j-1}, each times its norm, so that scaling them costs no pass.
void LanczosPropagator::add_vector() {
  const std::size_t j = alpha_.size();
  const std::span<double> next = basis_.at(j + 1);
  const double* now = basis_[j];
  Stage stage{.y1 = now, .a = 0, .d = -1 / norm_[j]};
  if (j > 0) stage.y2 = basis_[j - 1], stage.b = -norm_[j] / norm_[j - 1];
  rhs().linear_stage(stage, next);
  alpha_.push_back(dot({now, next.size()}, next) / norm_[j]);
  const double square = rhs().reduction().sum(
      [w = next.data(), v = now, c = rhs().capacities().data(), part = alpha_[j] / norm_[j]](std::size_t i) {
        w[i] -= part * v[i];
        return c[i] * w[i] * w[i];
      });
  bound_.add_row(alpha_[j], norm_[j]);
  norm_.push_back(std::sqrt(square));
  if (plan().track_inflow) inflow_.push_back(rhs().linear_inflow({now, next.size()}) / norm_[j]);
}

/// Rigorous: the integral of the residual.
double LanczosPropagator::bound_at(double elapsed) const {
  const double residual = norm_.front() * norm_.back();  // |f_0| beta
  return residual > 0 ? std::exp(std::log(residual) + bound_.log_integral(elapsed)) * rms_over_norm() : 0;
}

/// The bound takes what the residual leaves for undamped, and where it oscillates from node to node it is a
/// hundred times too large. Where the recurrence has become regular, as it does in networks without stiff
/// parts, it is continued by its own mirror image, and what that changes is the error; else the bound stands.
double LanczosPropagator::estimate_at(double elapsed) const {
  constexpr double regular = 4, safety = 3;
  const std::size_t m = alpha_.size(), half = m / 2;
  const std::span<const double> alpha = alpha_, beta = std::span(norm_).subspan(1);  // beta[j] leads beyond j
  const auto within = [&](std::span<const double> part) {
    const auto [low, high] = std::minmax_element(part.begin(), part.end());
    return *high <= regular * *low;
  };
  if (half == 0 || !within(alpha.subspan(half)) || !within(beta.subspan(half))) return bound_at(elapsed);
  std::vector<double> diagonal(alpha.begin(), alpha.end()), off(beta.begin(), beta.end());
  for (std::size_t j = m; j-- > half;) {
    diagonal.push_back(alpha[j]);
    if (j > half) off.push_back(beta[j - 1]);
  }
  const double time[] = {elapsed};
  const auto now = tridiagonal_responses(alpha, beta.first(m - 1), time).front().value;
  const auto later = tridiagonal_responses(diagonal, off, time).front().value;
  double square = 0;
  for (std::size_t j = 0; j < later.size(); ++j) {
    const double change = later[j] - (j < m ? now[j] : 0.0);
    square += change * change;
  }
  return std::min(bound_at(elapsed), safety * norm_.front() * std::sqrt(square) * rms_over_norm());
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

/// Adds coefficients[k][j] basis_[j] to the state of output k.
void LanczosPropagator::add_basis(std::span<Output> outputs,
                                  const std::vector<std::vector<double>>& coefficients) const {
  const std::size_t n = start_.size(), m = alpha_.size();
  const auto factor_of = [&](std::size_t k, std::size_t j) {
    return j < coefficients[k].size() ? coefficients[k][j] : 0.0;
  };
  for_ranges((n + stretch_of_entries - 1) / stretch_of_entries, n, [&](std::size_t from, std::size_t to) {
    for (std::size_t part = from; part < to; ++part) {
      const std::size_t first = part * stretch_of_entries, last = std::min(first + stretch_of_entries, n);
      for (std::size_t j = 0; j < m; j += 4) {
        const auto vector = [&](std::size_t k) { return basis_[std::min(j + k, m - 1)]; };
        const double *v0 = vector(0), *v1 = vector(1), *v2 = vector(2), *v3 = vector(3);
        for (std::size_t k = 0; k < outputs.size(); ++k) {
          if (outputs[k].state.empty() || j >= coefficients[k].size()) continue;
          const double c0 = factor_of(k, j), c1 = factor_of(k, j + 1);
          const double c2 = factor_of(k, j + 2), c3 = factor_of(k, j + 3);
          double* state = outputs[k].state.data();
          for (std::size_t i = first; i < last; ++i)
            state[i] += (c0 * v0[i] + c1 * v1[i]) + (c2 * v2[i] + c3 * v3[i]);
        }
      }
    }
  });
}

/// Coefficients of unit vectors without those at the end that add less than a thousandth of the tolerance:
/// early instants need fewer vectors than the last one.
std::vector<double> LanczosPropagator::significant(std::vector<double> coefficients) const {
  constexpr double insignificant = 1e-3;
  double square = 0;
  while (!coefficients.empty()) {
    square += coefficients.back() * coefficients.back();
    if (norm_[0] * std::sqrt(square) * rms_over_norm() > insignificant * allowed()) break;
    coefficients.pop_back();
  }
  return coefficients;
}

/// States, probes and inflows at instants that the space covers.
void LanczosPropagator::evaluate(std::span<Output> outputs) {
  std::vector<double> times, beta(norm_.begin() + 1, norm_.end());
  for (const auto& output : outputs) times.push_back(output.elapsed - offset_);
  auto responses = tridiagonal_responses(alpha_, beta, times);
  std::vector<std::vector<double>> coefficients;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    Output& output = outputs[k];
    output.inflow = start_inflow_ + times[k] * rate_of_inflow_;
    for (std::size_t j = 0; j < inflow_.size(); ++j)
      output.inflow += norm_[0] * responses[k].integral[j] * inflow_[j];
    coefficients.push_back(significant(std::move(responses[k].value)));
    for (std::size_t j = 0; j < coefficients[k].size(); ++j) coefficients[k][j] *= norm_[0] / norm_[j];
    for (std::size_t p = 0; p < plan().probes.size(); ++p) {
      const std::size_t probe = plan().probes[p];
      output.probes[p] = start_[probe];
      for (std::size_t j = 0; j < coefficients[k].size(); ++j)
        output.probes[p] += coefficients[k][j] * basis_[j][probe];
    }
    std::copy_n(start_.begin(), output.state.size(), output.state.begin());
  }
  add_basis(outputs, coefficients);
  // Each product rounds by some epsilons of rho, which then act as the residual does.
  double sum = 0;
  for (const double integral : responses.back().integral) sum += std::abs(integral);
  constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();
  const double rounding = roundings * rhs().spectral_bound(now(), start_) * norm_[0] * sum * rms_over_norm();
  const double stored = std::numeric_limits<double>::epsilon() * magnitude() * span();
  const double reached = bound_at(times.back()) + rounding + stored;
  if (!(reached < span())) return give_up_bound();
  if (reached > reported_) add_bound((reached - std::exchange(reported_, reached)) / span());
}

/// A new space from a time [s since the origin] that this one covers.
Outcome LanczosPropagator::restart_at(double covered, double error) {
  if (!(covered > offset_))
    return {Status::failed, fmt::format("{} Lanczos vectors do not cover any time; give them more memory, or "
                                        "use basis=chebyshev",
                                        alpha_.size())};
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

/// Adds vectors until the space covers `elapsed`, is exhausted, or is as large as it may be.
Outcome LanczosPropagator::grow(double elapsed) {
  constexpr double first_look = 5e3;  // times the tolerance: how much the bound may be too large
  double looseness = first_look;      // bound over estimate, as last seen
  covered_ = false;
  while (true) {
    const double bound = bound_at(elapsed);
    if (bound <= unspent_) covered_ = true;
    if (!covered_ && bound <= looseness * unspent_) {
      const double estimate = estimate_at(elapsed);
      covered_ = estimate <= unspent_;
      // The next look is where both will have fallen enough; soon, where the bound stood for the estimate.
      const double soon = 0.5 * bound / unspent_;
      looseness = estimate < bound ? std::min(bound / estimate, soon) : soon;
    }
    if (covered_ || norm_.back() == 0 || alpha_.size() == most_vectors_) break;
    if (stop_requested()) return interrupted_at(now() + offset_);
    add_vector();
  }
  count_terms(alpha_.size());
  return stop_requested() ? interrupted_at(now() + offset_) : Outcome{};
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
