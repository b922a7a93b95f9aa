#include "bench/lab/frozen/growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/lab/perturbation.hpp"

namespace superstep {
namespace {

constexpr double noise = 0.1;  // beside the mode: enough for another one to win where it grows faster
constexpr int steps_of_real_modes = 60;      // two modes that grow 4 % apart differ by a factor of ten then
constexpr int steps_of_complex_modes = 400;  // a mode that turns shows its mean only after some turns
constexpr double distinguishable = 1e-4;

}  // namespace

GrowthMeter::GrowthMeter(Rhs& rhs, std::vector<double> mode, Modes modes, double rising)
    : rhs_(rhs),
      mode_(std::move(mode)),
      start_(white_perturbation(rhs)),
      image_(rhs.size()),
      orthogonal_(modes == Modes::orthogonal),
      rising_(rising),
      steps_(modes == Modes::complex ? steps_of_complex_modes : steps_of_real_modes) {
  normalise(rhs_, mode_);
  for (std::size_t i = 0; i < start_.size(); ++i) start_[i] = mode_[i] + noise * start_[i];
}

GrowthMeter::GrowthMeter(Rhs& rhs, std::vector<Mode> modes) : rhs_(rhs), modes_(std::move(modes)) {}

double GrowthMeter::growth_of_each(const std::string& spec, double step) {
  StepOperator one_step(rhs_, spec, step);
  double largest = 0;
  for (const Mode& mode : modes_) {
    double before = 0, after = 0;  // squares of norms
    for (const auto* part : {&mode.real, &mode.imaginary}) {
      if (part->empty()) continue;
      before += capacity_product(rhs_, *part, *part);
      auto e = *part;
      if (!one_step.apply(e)) return std::numeric_limits<double>::infinity();
      after += capacity_product(rhs_, e, e);
    }
    largest = std::max(largest, std::sqrt(after / before));
  }
  return largest;
}

void GrowthMeter::take_slow_modes_away(std::vector<double>& e) {
  rhs_.linear_stage({.y1 = e.data(), .a = 0, .d = 1}, image_);
  std::swap(e, image_);
  if (!(rising_ > 0)) return;
  normalise(rhs_, e);
  rhs_.linear_stage({.y1 = e.data(), .a = -rising_, .d = 1}, image_);
  std::swap(e, image_);
}

double GrowthMeter::growth(const std::string& spec, double step) {
  ++runs_;
  if (!modes_.empty()) return growth_of_each(spec, step);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  StepOperator one_step(rhs_, spec, step);
  double alone = 0;
  if (orthogonal_) {
    auto e = mode_;
    if (!one_step.apply(e)) return infinity;
    alone = normalise(rhs_, e);
  }
  auto e = start_;
  double later = 0;  // sum of logarithms
  const int half = steps_ / 2;
  for (int k = 1; k <= steps_; ++k) {
    normalise(rhs_, e);
    if (!one_step.apply(e)) return infinity;
    const double factor = normalise(rhs_, e);
    if (!std::isfinite(factor)) return infinity;
    if (!(factor > 0)) return alone;
    if (k > half) later += std::log(factor);
    take_slow_modes_away(e);
  }
  return std::max(alone, std::exp(later / (steps_ - half)));
}

Tendency tendency(double growth) noexcept {
  if (std::abs(growth - 1) <= distinguishable) return Tendency::unclear;
  return growth < 1 ? Tendency::decays : Tendency::grows;
}

double longest_stable_step(const std::function<double(double step)>& growth, double first, double width) {
  constexpr int most_doublings = 200;
  const auto stable = [&](double step) { return growth(step) <= 1; };
  double low = first, high = 2 * first;
  for (int k = 0; k < most_doublings && !stable(low); ++k) {
    high = low;
    low *= 0.5;
  }
  for (int k = 0; stable(high); ++k) {
    if (k == most_doublings) return std::numeric_limits<double>::infinity();
    low = high;
    high *= 2;
  }
  while (high - low > width * low) {
    const double middle = 0.5 * (low + high);
    (stable(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace superstep
