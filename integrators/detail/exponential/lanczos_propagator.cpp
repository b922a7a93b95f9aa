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
}

void LanczosPropagator::start_over() {
  open_ = false;
  offset_ = start_inflow_ = 0;
  unspent_ = allowed();
  std::copy(origin().begin(), origin().end(), start_.begin());
}

void LanczosPropagator::open_space() {
  open_ = true;
  reported_ = 0;
  norm_.clear();
  alpha_.clear();
  inflow_.clear();
  bound_ = ResidualBound(stretch() - offset_);
  if (basis_.empty()) basis_.emplace_back(rhs().size());
  rhs()(now() + offset_, start_, basis_[0]);
  norm_.push_back(std::sqrt(dot(basis_[0], basis_[0])));
  rate_of_inflow_ = plan().track_inflow ? rhs().inflow(now() + offset_, start_) : 0;
}

/// One sweep: v_{j+1} from v_j and v_{j-1}, each times its norm, so that scaling them costs no pass.
void LanczosPropagator::add_vector() {
  const std::size_t j = alpha_.size();
  if (j + 1 == basis_.size()) basis_.emplace_back(rhs().size());
  StateVector& next = basis_[j + 1];
  Stage stage{.y1 = basis_[j].data(), .a = 0, .d = -1 / norm_[j]};
  if (j > 0) stage.y2 = basis_[j - 1].data(), stage.b = -norm_[j] / norm_[j - 1];
  rhs().linear_stage(stage, next);
  alpha_.push_back(dot(basis_[j], next) / norm_[j]);
  const double square =
      rhs().reduction().sum([w = next.data(), v = basis_[j].data(), c = rhs().capacities().data(),
                             part = alpha_[j] / norm_[j]](std::size_t i) {
        w[i] -= part * v[i];
        return c[i] * w[i] * w[i];
      });
  bound_.add_row(alpha_[j], norm_[j]);
  norm_.push_back(std::sqrt(square));
  if (plan().track_inflow) inflow_.push_back(rhs().linear_inflow(basis_[j]) / norm_[j]);
}

/// Bound of the rms error after `elapsed` in the present space; `rms_of_residual_` for the vector beyond it.
double LanczosPropagator::error_at(double elapsed) const {
  const double residual = norm_.front() * norm_.back();  // |f_0| beta
  if (residual == 0) return 0;
  return std::exp(std::log(residual) + bound_.log_integral(elapsed)) * rms_of_residual_;
}

bool LanczosPropagator::covers(double elapsed, double error) const {
  return error_at(elapsed) <= error;
}

/// Longest time that the present space covers: the bound grows with time.
double LanczosPropagator::time_covered(double longest, double error) const {
  double low = 0, high = longest;
  constexpr int bisections = 40;
  for (int k = 0; k < bisections; ++k) {
    const double middle = 0.5 * (low + high);
    (covers(middle, error) ? low : high) = middle;
  }
  return low;
}

/// Adds coefficients[k][j] basis_[j] to the state of output k.
void LanczosPropagator::add_basis(std::span<Output> outputs,
                                  const std::vector<std::vector<double>>& coefficients) const {
  const std::size_t n = start_.size(), m = alpha_.size();
  for_ranges((n + stretch_of_entries - 1) / stretch_of_entries, n, [&](std::size_t from, std::size_t to) {
    for (std::size_t part = from; part < to; ++part) {
      const std::size_t first = part * stretch_of_entries, last = std::min(first + stretch_of_entries, n);
      for (std::size_t j = 0; j < m; j += 4) {
        const auto vector = [&](std::size_t k) { return basis_[std::min(j + k, m - 1)].data(); };
        const double *v0 = vector(0), *v1 = vector(1), *v2 = vector(2), *v3 = vector(3);
        for (std::size_t k = 0; k < outputs.size(); ++k) {
          if (outputs[k].state.empty()) continue;
          const auto factor = [&](std::size_t i) { return j + i < m ? coefficients[k][j + i] : 0.0; };
          const double c0 = factor(0), c1 = factor(1), c2 = factor(2), c3 = factor(3);
          double* state = outputs[k].state.data();
          for (std::size_t i = first; i < last; ++i)
            state[i] += (c0 * v0[i] + c1 * v1[i]) + (c2 * v2[i] + c3 * v3[i]);
        }
      }
    }
  });
}

/// States, probes and inflows at instants that the space covers.
void LanczosPropagator::evaluate(std::span<Output> outputs) {
  const std::size_t m = alpha_.size();
  std::vector<double> times, beta(norm_.begin() + 1, norm_.end());
  for (const auto& output : outputs) times.push_back(output.elapsed - offset_);
  auto responses = tridiagonal_responses(alpha_, beta, times);
  std::vector<std::vector<double>> coefficients;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    Output& output = outputs[k];
    output.inflow = start_inflow_ + times[k] * rate_of_inflow_;
    for (std::size_t j = 0; j < inflow_.size(); ++j)
      output.inflow += norm_[0] * responses[k].integral[j] * inflow_[j];
    coefficients.push_back(std::move(responses[k].value));
    for (std::size_t j = 0; j < m; ++j) coefficients[k][j] *= norm_[0] / norm_[j];
    for (std::size_t p = 0; p < plan().probes.size(); ++p) {
      const std::size_t probe = plan().probes[p];
      output.probes[p] = start_[probe];
      for (std::size_t j = 0; j < m; ++j) output.probes[p] += coefficients[k][j] * basis_[j][probe];
    }
    std::copy_n(start_.begin(), output.state.size(), output.state.begin());
  }
  add_basis(outputs, coefficients);
  // Each product rounds by some epsilons of rho, which then act as the residual does.
  double sum = 0;
  for (const double integral : responses.back().integral) sum += std::abs(integral);
  constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();
  const double rounding = roundings * rhs().spectral_bound(now(), start_) * norm_[0] * sum * rms_over_norm();
  const double reached = error_at(times.back()) + rounding;
  if (span() > 0 && reached > reported_) add_bound((reached - std::exchange(reported_, reached)) / span());
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
  rms_of_residual_ = rms_over_norm();
  while (!covers(elapsed, unspent_) && norm_.back() > 0 && alpha_.size() < most_vectors_) {
    if (stop_requested()) return interrupted_at(now() + offset_);
    add_vector();
    if (covers(elapsed, unspent_)) break;
    // The largest value of v_{m+1} is at least 1/|1|: worth a pass where that would do.
    rms_of_residual_ = 1 / norm_of_one();
    const bool worth_a_pass = covers(elapsed, unspent_);
    rms_of_residual_ = rms_over_norm();
    if (!worth_a_pass) continue;
    const double largest =
        rhs().reduction().max([v = basis_[alpha_.size()].data()](std::size_t i) { return std::abs(v[i]); });
    rms_of_residual_ = std::min(rms_of_residual_, largest / norm_.back());
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
    if (covers(remaining, unspent_)) break;
    // A space that is not the last one leaves half of what may still be spent to those that follow.
    const double error = 0.5 * unspent_, covered = offset_ + time_covered(remaining, error);
    const auto end = std::find_if(outputs.begin(), outputs.end(),
                                  [&](const Output& output) { return output.elapsed > covered; });
    const auto done = static_cast<std::size_t>(end - outputs.begin());
    if (done > 0) evaluate(outputs.first(done));
    outputs = outputs.subspan(done);
    if (Outcome outcome = restart_at(covered, error); !outcome.ok()) return outcome;
  }
  evaluate(outputs);
  return {};
}

}  // namespace superstep
