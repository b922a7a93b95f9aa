#include "integrators/detail/run_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace superstep {
namespace {

constexpr double allowed_spans = 10;

}  // namespace

void RunGuard::prepare(const Rhs& rhs, const Plan& plan) {
  rhs_ = &rhs;
  ranges_ = plan.ranges;
  t_begin_ = plan.t_begin;
  source_rate_.clear();
  for (std::size_t f = 0; f < rhs.fields().size(); ++f) source_rate_.push_back(rhs.source_rate(f));
  stop_ = plan.stop;
  reached_ = plan.reached;
}

Outcome RunGuard::check(double t, std::span<const double> y) const {
  const auto fields = rhs_->fields();
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const double widened = t > t_begin_ ? source_rate_[f] * (t - t_begin_) : 0;
    const double low = ranges_[f].low - widened, high = ranges_[f].high + widened;
    const double rounding = 1e-6 * std::max(std::abs(low), std::abs(high));
    const double slack = allowed_spans * (high - low) + rounding + std::numeric_limits<double>::min();
    for (std::size_t k = 0, i = fields[f].offset; k < fields[f].count; ++k, i += fields[f].stride) {
      if (y[i] >= low - slack && y[i] <= high + slack) continue;  // false for NaN as well
      return {Status::unstable,
              fmt::format(
                  "at t = {:.6g} s the {} of a node is {:.6g} {}, while initial and fixed values and sources "
                  "allow {:.6g} to {:.6g}: errors grow; take a smaller step",
                  t, fields[f].name, y[i], fields[f].unit, low, high)};
    }
  }
  return {};
}

Outcome interrupted_at(double t) {
  return {Status::interrupted, fmt::format("stopped on request at t = {:.6g} s", t)};
}

std::uint64_t steps_to_cover(double span, double step) noexcept {
  if (!(span > 0)) return 0;
  constexpr double rounding = 1e-12;
  const double steps = std::ceil(span / step * (1 - rounding));
  constexpr double largest = 1e18;
  return static_cast<std::uint64_t>(std::clamp(steps, 1.0, largest));
}

void ProbeRecorder::prepare(const Plan& plan) {
  history_ = plan.history;
  probes_ = plan.probes;
  values_.resize(longest_chain * probes_.size());
}

void ProbeRecorder::record(double t, std::span<const double> y) {
  if (!history_) return;
  for (std::size_t k = 0; k < probes_.size(); ++k) values_[k] = y[probes_[k]];
  record_followed(t, 0);
}

ChainObserver& ProbeRecorder::follow(std::span<const ChainedStage> chain) noexcept {
  chain_ = chain;
  return *this;
}

void ProbeRecorder::entries_done(std::size_t stage, std::size_t first, std::size_t last) {
  for (std::size_t k = 0; k < probes_.size(); ++k)
    if (probes_[k] >= first && probes_[k] < last)
      values_[stage * probes_.size() + k] = chain_[stage].out[probes_[k]];
}

void ProbeRecorder::record_followed(double t, std::size_t k) {
  history_->append(t, std::span(values_).subspan(k * probes_.size(), probes_.size()));
}

}  // namespace superstep
