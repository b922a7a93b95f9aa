#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "integrators/detail/driver/driver.hpp"
#include "integrators/driver.hpp"

namespace superstep {
namespace {

[[noreturn]] void complain(const std::string& what) {
  throw std::invalid_argument("Plan: " + what);
}

/// What a caller may get wrong about a run; everything behind relies on it.
void require_sensible(const Plan& plan, const Rhs& rhs) {
  const std::size_t fields = rhs.fields().size();
  if (plan.output_times.empty()) complain("output_times is empty; give at least the end of the run [s]");
  double last = plan.t_begin;
  for (const double t : plan.output_times) {
    if (!(std::isfinite(t) && t > last))
      complain(
          fmt::format("output time {} s does not lie after {} s; they must ascend, beyond t_begin", t, last));
    last = t;
  }
  if (plan.ranges.size() != fields)
    complain(fmt::format("{} ranges for {} fields; give one each", plan.ranges.size(), fields));
  if (!plan.spans.empty() && plan.spans.size() != fields)
    complain(fmt::format("{} spans for {} fields; give one each, or none", plan.spans.size(), fields));
  for (const double span : plan.spans)
    if (!(std::isfinite(span) && span >= 0))
      complain(fmt::format("a span is {}; it must be finite and >= 0", span));
  for (const std::size_t entry : plan.probes)
    if (entry >= rhs.size())
      complain(fmt::format("probe {} is beyond the {} entries of the state", entry, rhs.size()));
}

}  // namespace

Integrator::Integrator(std::unique_ptr<Method> method)
    : driver_(std::make_unique<Driver>(std::move(method))) {}
Integrator::~Integrator() = default;

void Integrator::prepare(Rhs& rhs, const Plan& plan) {
  require_sensible(plan, rhs);
  driver_->prepare(rhs, plan);
}

void Integrator::start(double t, std::span<const double> y) {
  if (y.size() != driver_->size())
    throw std::invalid_argument(
        fmt::format("a state of {} entries where the right-hand side has {}", y.size(), driver_->size()));
  driver_->start(t, y);
}

Outcome Integrator::advance(double t_out) {
  return driver_->advance(t_out);
}

double Integrator::time() const noexcept {
  return driver_->time();
}

std::span<const double> Integrator::state() const noexcept {
  return driver_->state();
}

const Statistics& Integrator::statistics() const noexcept {
  return driver_->statistics();
}

double Integrator::rtol() const {
  return driver_->rtol();
}

std::string Integrator::choice() const {
  return driver_->choice();
}

std::optional<double> Integrator::settled_at() const noexcept {
  return driver_->settled_at();
}

}  // namespace superstep
