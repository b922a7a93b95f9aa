#include "integrators/detail/driver/run_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace superstep {
namespace {

constexpr double allowed_spans = 10;

}  // namespace

void RunGuard::prepare(const Rhs& rhs, const Plan& plan) {
  ranges_ = plan.ranges;
  t_begin_ = plan.t_begin;
  source_rate_.clear();
  const auto& facts = rhs.facts().fields;
  for (std::size_t f = 0; f < facts.size(); ++f) {
    source_rate_.push_back(facts[f].source_rate);
    ranges_[f].take(facts[f].ambient);
  }
  stop_ = plan.stop;
}

void RunGuard::agree(const Rhs& rhs) {
  Communicator* among = rhs.reduction().among();
  if (!among) return;
  constexpr unsigned most_silent = 8;
  if (among->traffic().reductions == reductions_ && ++silent_ >= most_silent) (void)among->any(false);
  if (among->traffic().reductions != reductions_) silent_ = 0;
  reductions_ = among->traffic().reductions;
}

Outcome RunGuard::check(double t, std::span<const double> y, const Rhs& rhs) const {
  auto growth = growth_of(t, y, rhs);
  if (Communicator* among = rhs.reduction().among()) growth = among->first_of(growth);
  if (growth) return {Status::unstable, std::move(*growth)};
  return {};
}

std::optional<std::string> RunGuard::growth_of(double t, std::span<const double> y, const Rhs& rhs) const {
  const auto fields = rhs.fields();
  const std::size_t settled = ranges_.size() - fields.size();
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const FieldRange range = attainable_range(
        ranges_[settled + f], {.source_rate = source_rate_[settled + f], .ambient = {}}, t - t_begin_);
    const double rounding = 1e-6 * range.magnitude();
    const double slack = allowed_spans * range.span() + rounding + std::numeric_limits<double>::min();
    for (std::size_t k = 0, i = fields[f].offset; k < fields[f].count; ++k, i += fields[f].stride) {
      if (y[i] >= range.low - slack && y[i] <= range.high + slack) continue;  // false for NaN as well
      return fmt::format(
          "at t = {:.6g} s the {} of a node is {:.6g} {}, while initial and fixed values, surroundings "
          "and sources allow {:.6g} to {:.6g}: errors grow; take a smaller step",
          t, fields[f].name, y[i] + fields[f].origin, fields[f].unit, range.low + fields[f].origin,
          range.high + fields[f].origin);
    }
  }
  return std::nullopt;
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

}  // namespace superstep
