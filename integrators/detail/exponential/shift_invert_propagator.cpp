#include "integrators/detail/exponential/shift_invert_propagator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.hpp"
#include "integrators/detail/driver/run_guard.hpp"

namespace superstep {
namespace {

constexpr std::size_t most_vectors = 120;  // fifty serve two decades to 1e-10
constexpr double safety = 3;  // over what the last two vectors changed: spectra of every kind were within

constexpr double contracting = 0.5;  // corrections of a solution that can be corrected

Outcome no_factor() {
  return {
      Status::failed,
      "C + gamma K could not be factorized: it is singular to working precision, as it becomes where t_end "
      "is long beside the fastest exchange, or memory is short; take cvode"};
}

}  // namespace

void ShiftInvertPropagator::allocate() {
  if (!rhs().traits().autonomous)
    throw Refused("basis=shift-invert is for constant inputs; leave it out where they change in time");
  solver_ = rhs().size() > 0 ? make_cholmod_solver(rhs()) : nullptr;
  for (auto* v : {&work_, &correction_}) v->resize(rhs().size());
}

void ShiftInvertPropagator::add_counts(Statistics& statistics) const {
  InstantBatch::add_counts(statistics);
  if (!solver_) return;
  statistics.factorizations += solver_->factorizations();
  statistics.solves += solver_->solves();
}

void ShiftInvertPropagator::reset_counts() {
  InstantBatch::reset_counts();
  if (solver_) solver_->reset_counts();
}

bool ShiftInvertPropagator::solve(std::span<const double> v, StateVector& out) {
  if (!solver_->solve(v, out, 0)) return false;
  if (!refines_) return true;
  // By differences of neighbours: what an assembled diagonal has lost of small capacities is still there.
  constexpr double found = 1e-9;  // of v, which nothing makes larger
  const double whole = std::sqrt(dot(v, v));
  constexpr int most_rounds = 12;
  double before = 0;
  for (int round = 0; round < most_rounds; ++round) {
    rhs().linear_stage({.y1 = out.data(), .a = -1, .d = projection_.pole(), .y0 = v.data(), .c = 1}, work_);
    if (!solver_->solve(work_, correction_, 0)) return false;
    for_each_entry(out.size(), [&](std::size_t i) { out[i] += correction_[i]; });
    const double size = std::sqrt(dot(correction_, correction_));
    if (!(size > found * whole)) {
      const double left = size * std::min(contracting, size / (round > 0 ? before : whole));
      error_of_solutions_ = std::max(error_of_solutions_, left / whole);
      return true;
    }
    if (round > 0 && size > contracting * before) return false;
    before = size;
  }
  return false;
}

/// basis_[0] = p, found as an implicit Euler step: f at its smooth end has none of the rounding that f at a
/// rough start has, which would feed the slow modes for the whole time.
bool ShiftInvertPropagator::find_first_step() {
  const double pole = projection_.pole();
  StateVector& p = basis_.front();
  StateVector end(rhs().size());
  const auto add = [&](const StateVector& change, double factor) {
    for_each_entry(p.size(), [&](std::size_t i) { p[i] += factor * change[i]; });
  };
  std::fill(p.begin(), p.end(), 0.0);
  rhs()(now(), origin(), work_);
  if (!solver_->solve(work_, correction_, 0)) return false;
  add(correction_, pole);
  constexpr double harmless = 1e-3;  // part of the tolerance
  constexpr int most_rounds = 12;
  double before = 0;
  for (int round = 0;; ++round) {
    for_each_entry(p.size(), [&](std::size_t i) { end[i] = origin()[i] + p[i]; });
    rhs().stage(now(), {.y1 = end.data(), .a = -1, .d = pole, .y0 = origin().data(), .c = 1}, work_);
    if (!solver_->solve(work_, correction_, 0)) return false;
    add(correction_, 1);
    const double size = std::sqrt(dot(correction_, correction_));
    error_of_start_ = size;
    if (size * rms_over_norm() <= harmless * allowed()) return true;
    // Corrections end at the roundings of the values; where the matrix hides what is slow they never shrink.
    constexpr double rounding = 1e-6;  // of the step
    if (round > 0 && size > contracting * before) return size <= rounding * std::sqrt(dot(p, p));
    if (round == most_rounds) return true;
    refines_ = true;
    before = size;
  }
}

bool ShiftInvertPropagator::open_space() {
  constexpr double part_of_time = 0.1;  // of the time between the instants that it serves
  projection_ = RationalProjection(part_of_time * std::sqrt(shortest_ * longest_));
  exhausted_ = refines_ = false;
  if (basis_.empty()) basis_.emplace_back(rhs().size());
  if (!solver_->set(projection_.pole(), now(), origin()) || !find_first_step()) return false;
  StateVector& p = basis_.front();
  length_ = std::sqrt(dot(p, p));
  exhausted_ = length_ == 0;
  beyond_ = 0;
  // Where nothing needs a correction a solution is no worse than this first one was.
  constexpr double roundings = 8 * std::numeric_limits<double>::epsilon();
  error_of_solutions_ = roundings + (refines_ || exhausted_ ? 0 : error_of_start_ / length_);
  if (!exhausted_) for_each_entry(p.size(), [&](std::size_t i) { p[i] /= length_; });
  return true;
}

/// Orthogonalizes twice: the small problem takes the basis to be orthonormal.
bool ShiftInvertPropagator::add_vector() {
  const std::size_t m = projection_.dimension();
  if (m + 1 == basis_.size()) basis_.emplace_back(rhs().size());
  StateVector& next = basis_[m + 1];
  if (!solve(basis_[m], next)) return false;
  const double before = std::sqrt(dot(next, next));
  std::vector<double> products(m + 1, 0.0);
  for (int round = 0; round < 2; ++round) {
    std::vector<double> part;
    for (std::size_t j = 0; j <= m; ++j) part.push_back(dot(basis_[j], next));
    for (std::size_t j = 0; j <= m; ++j) {
      products[j] += part[j];
      for_each_entry(next.size(),
                     [&, v = basis_[j].data(), w = next.data()](std::size_t i) { w[i] -= part[j] * v[i]; });
    }
  }
  projection_.add_vector(products);
  const double norm = std::sqrt(dot(next, next));
  constexpr double nothing = 1e-15;  // left: the space holds all that p excites
  exhausted_ = !(norm > nothing * before);
  beyond_ = norm;
  if (!exhausted_) for_each_entry(next.size(), [&](std::size_t i) { next[i] /= norm; });
  return true;
}

double ShiftInvertPropagator::rms_of(const std::vector<double>& coefficients) const {
  const double sum = rhs().reduction().sum([&](std::size_t i) {
    double value = 0;
    for (std::size_t j = 0; j < coefficients.size(); ++j) value += coefficients[j] * basis_[j][i];
    return value * value;
  });
  return std::sqrt(sum / static_cast<double>(rhs().size()));
}

double ShiftInvertPropagator::last_change(std::span<const Output> outputs) const {
  constexpr std::size_t most_looks = 8;
  const std::size_t stride = 1 + (outputs.size() - 1) / most_looks;
  double largest = 0;
  for (std::size_t k = 0; k < outputs.size(); k += stride) {
    const double t = outputs[outputs.size() - 1 - k].elapsed;
    for (std::size_t less = 1; less < RationalProjection::kept; ++less) {
      auto change = projection_.response(t).value;
      const auto before = projection_.response(t, less).value;
      double square = 0;
      for (std::size_t j = 0; j < change.size(); ++j) {
        if (j < before.size()) change[j] -= before[j];
        change[j] *= length_;
        square += change[j] * change[j];
      }
      // The capacity norm bounds the rms; only where that is not enough is the rms itself worth a pass.
      const double bound = std::sqrt(square) * rms_over_norm();
      largest = std::max(largest, bound <= allowed() / safety ? bound : rms_of(change));
      if (largest > allowed() / safety) return largest;
    }
  }
  return largest;
}

Outcome ShiftInvertPropagator::grow(std::span<const Output> outputs) {
  while (!exhausted_) {
    if (stop_requested()) return interrupted_at(now());
    if (projection_.dimension() >= RationalProjection::kept && safety * last_change(outputs) <= allowed())
      break;
    if (projection_.dimension() >= most_vectors)
      return {Status::failed,
              fmt::format("{} solves did not reach the tolerance; use basis=chebyshev", most_vectors)};
    if (!add_vector()) return no_factor();
  }
  count_terms(projection_.dimension());
  return stop_requested() ? interrupted_at(now()) : Outcome{};
}

void ShiftInvertPropagator::evaluate(std::span<Output> outputs) {
  const std::size_t m = projection_.dimension();
  std::vector<double> inflow;
  for (std::size_t j = 0; j < m && plan().track_inflow; ++j) inflow.push_back(rhs().linear_inflow(basis_[j]));
  const double rate = plan().track_inflow ? rhs().inflow(now(), origin()) : 0;
  for (auto& output : outputs) {
    RationalProjection::Response response;
    if (m > 0) response = projection_.response(output.elapsed);
    output.inflow = output.elapsed * rate;
    for (std::size_t j = 0; j < inflow.size(); ++j)
      output.inflow += length_ * response.integral[j] * inflow[j];
    const auto value = [&](std::size_t i) {
      double sum = 0;
      for (std::size_t j = 0; j < m; ++j) sum += response.value[j] * basis_[j][i];
      return origin()[i] + length_ * sum;
    };
    for (std::size_t p = 0; p < plan().probes.size(); ++p) output.probes[p] = value(plan().probes[p]);
    for_each_entry(output.state.size(), [&](std::size_t i) { output.state[i] = value(i); });
  }
}

void ShiftInvertPropagator::report_bound(std::span<const Output> outputs) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  constexpr double near = 1.3;  // times whose errors are alike
  const auto m = static_cast<double>(projection_.dimension());
  RationalError largest;
  double looked_at = 0;
  for (const auto& output : outputs) {
    if (m == 0 || (output.elapsed < near * looked_at && &output != &outputs.back())) continue;
    looked_at = output.elapsed;
    const RationalError error = projection_.error(looked_at);
    largest = {std::max(largest.next, error.next), std::max(largest.images, error.images)};
  }
  const double slowest = 1 + outputs.back().elapsed / projection_.pole();  // what p becomes at most
  const double start = slowest * (error_of_start_ + m * epsilon * length_);
  const double images = std::sqrt(m) * error_of_solutions_ * length_ * largest.images;
  const double stored = epsilon * magnitude() * span();
  add_growth(
      {beyond_ * length_ * largest.next * rms_over_norm(), (start + images) * rms_over_norm() + stored},
      reported_);
}

std::span<InstantBatch::Output> ShiftInvertPropagator::serve(std::span<Output> outputs) {
  if (outputs.front().elapsed > longest_ || outputs.front().elapsed < shortest_) {
    shortest_ = outputs.front().elapsed;
    const double end = widest * shortest_;
    for (const auto& output : outputs)
      if (output.elapsed <= end) longest_ = output.elapsed;
    if (stretch() <= end) longest_ = stretch();
    if (!open_space()) return {};
  }
  const auto last = std::find_if(outputs.begin(), outputs.end(),
                                 [&](const Output& output) { return output.elapsed > longest_; });
  return outputs.first(static_cast<std::size_t>(last - outputs.begin()));
}

Outcome ShiftInvertPropagator::propagate(std::span<Output> outputs) {
  if (rhs().spectral_bound(now(), origin()) == 0) return no_exchange(outputs);
  while (!outputs.empty()) {
    const auto served = serve(outputs);
    if (served.empty()) return no_factor();
    if (Outcome outcome = grow(served); !outcome.ok()) return outcome;
    evaluate(served);
    report_bound(served);
    outputs = outputs.subspan(served.size());
  }
  return {};
}

}  // namespace superstep
