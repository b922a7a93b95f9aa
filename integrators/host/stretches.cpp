#include "integrators/host/stretches.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/stopwatch.hpp"
#include "integrators/method_spec.hpp"
#include "integrators/registry.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep {
namespace {

/// Pairwise critical step of a network [s]; infinity without edges (Rojek & Nisar 2026, eqs 27-29).
double pair_step(const Network& network) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < network.size(); ++row)
    for (auto k = network.row_begin[row]; k < network.row_begin[row + 1]; ++k) {
      const double c_i = network.capacity[row];
      const double c_j =
          network.capacity[static_cast<std::size_t>(network.column[static_cast<std::size_t>(k)])];
      smallest = std::min(smallest,
                          2 * c_i * c_j / ((c_i + c_j) * network.conductance[static_cast<std::size_t>(k)]));
    }
  return smallest;
}

FieldRange range_of(const Network& network, std::span<const double> values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  FieldRange range{*low, *high};
  for (const auto& edge : network.ghost_edges) {
    const double value = network.ghost_value[static_cast<std::size_t>(edge.ghost)];
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  return range;
}

/// Tolerance of a stretch that may use up `share` of that of the run.
///   tightest  that the method takes
double shared(double rtol, double tightest, double share, double span, const FieldRange& range) {
  if (!(rtol > 0) || !(span > 0)) return rtol;
  constexpr double rounding = 100 * std::numeric_limits<double>::epsilon();
  const double least = std::max(rounding * std::max(range.magnitude() / span, 1.0), tightest);
  return std::min(rtol, std::max(share * rtol, least));
}

}  // namespace

Stretches::Stretches(std::string spec) : spec_(std::move(spec)) {
  const MethodSpec method(spec_);
  rtol_ = method.rtol();
  tightest_ = method.tightest_tolerance();
}

Stretches::~Stretches() = default;
Stretches::Stretches(Stretches&&) noexcept = default;
Stretches& Stretches::operator=(Stretches&&) noexcept = default;

void Stretches::take(Network network) {
  const double begin = process_cpu_seconds();
  integrator_.reset();
  const double step = pair_step(network);
  rhs_ = std::make_unique<NetworkRhs>(std::move(network), "temperature", "K", step);
  cpu_building_ += process_cpu_seconds() - begin;
}

/// Where nothing conducts: exact.
void Stretches::add_sources(double h, std::span<double> values) const {
  const Network& network = rhs_->network();
  for (std::size_t row = 0; row < values.size(); ++row)
    values[row] += h * network.source[row] / network.capacity[row];
}

bool Stretches::is_prepared(double h, double span, double rtol, const FieldRange& range) const noexcept {
  constexpr double little = 0.05;
  if (!integrator_ || h != h_ || stop != stop_ || rtol != rtol_now_) return false;
  if (span_ == 0 || span == 0) return false;  // the span was that of the stretch before
  const double slack = little * span_;
  return span <= span_ + slack && span >= span_ && range.low >= range_.low - slack &&
         range.high <= range_.high + slack;
}

void Stretches::prepare(double h, double span, double rtol, const FieldRange& range) {
  Plan plan;
  plan.output_times = {h};
  plan.ranges = {range};
  plan.stop = stop;
  if (span > 0) plan.spans = {span};
  integrator_ = make_integrator(rtol == rtol_ ? spec_ : MethodSpec(spec_).with_tolerance(rtol).text());
  integrator_->prepare(*rhs_, plan);
  h_ = h;
  span_ = span;
  rtol_now_ = rtol;
  range_ = range;
  stop_ = stop;
  ++preparations_;
}

Outcome Stretches::run(double h, std::span<double> values) {
  integrator_->start(0, values);
  Outcome outcome = integrator_->advance(h);
  const Statistics& statistics = integrator_->statistics();
  steps_ += statistics.steps;
  rejected_ += statistics.rejected;
  factorizations_ += statistics.factorizations;
  solves_ += statistics.solves;
  max_stages_ = std::max(max_stages_, statistics.max_stages);
  if (outcome.ok()) std::ranges::copy(integrator_->state(), values.begin());
  return outcome;
}

Outcome Stretches::advance(double h, std::span<double> values, double span, double share) {
  if (values.empty()) return {};
  const Network& network = rhs_->network();
  if (network.nonzeros() == 0 && network.ghost_edges.empty()) {
    add_sources(h, values);
    return {};
  }
  const double begin = process_cpu_seconds();
  const RhsCounters before = rhs_->counters();
  Outcome outcome;
  try {
    const FieldRange range = range_of(network, values);
    const double rtol = shared(rtol_, tightest_, share, span, range);
    if (!is_prepared(h, span, rtol, range)) prepare(h, span, rtol, range);
    outcome = run(h, values);
  } catch (const Refused& refused) {
    outcome = {Status::refused, refused.what()};
  } catch (const std::runtime_error& error) {  // of a factorization, say
    outcome = {Status::failed, error.what()};
  }
  const RhsCounters work = difference(rhs_->counters(), before);
  sweeps_ += work.sweeps;
  jacobians_ += work.jacobians;
  cpu_stepping_ += process_cpu_seconds() - begin;
  if (!outcome.ok()) {
    integrator_.reset();  // whatever state it is in
    outcome.reason = spec_ + ": " + outcome.reason;
  }
  return outcome;
}

}  // namespace superstep
