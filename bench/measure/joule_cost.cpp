#include "bench/measure/joule_cost.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "core/stopwatch.hpp"
#include "rhs/one_way.hpp"

namespace superstep {

JouleCost::JouleCost(const Scene& scene) : rhs_(*scene.rhs), halves_(rhs_.one_way()) {
  if (!halves_) return;
  state_.assign(scene.initial.begin(), scene.initial.end());
  next_.resize(state_.size());
  rate_.assign(halves_->driven().size(), 0.0);
}

// Stages of size 0: the values stay where they are, the work is that of any other.
double JouleCost::seconds_whole(std::size_t times) {
  const double begin = process_cpu_seconds();
  for (std::size_t k = 0; k < times; ++k) rhs_.stage(0, {.y1 = state_.data(), .a = 1, .d = 0}, next_);
  return process_cpu_seconds() - begin;
}

double JouleCost::seconds_halves(std::size_t times) {
  Rhs &driver = halves_->driver(), &driven = halves_->driven();
  const std::size_t split = driver.size();
  const std::span<double> out(next_);
  halves_->drive(rate_);
  const double begin = process_cpu_seconds();
  for (std::size_t k = 0; k < times; ++k) {
    driver.stage(0, {.y1 = state_.data(), .a = 1, .d = 0}, out.first(split));
    driven.stage(0, {.y1 = state_.data() + split, .a = 1, .d = 0}, out.subspan(split));
  }
  const double seconds = process_cpu_seconds() - begin;
  halves_->drive({});
  return seconds;
}

std::optional<double> JouleCost::sample() {
  if (!halves_) return std::nullopt;
  constexpr double batch = 5e-3;  // s, thousands of times what the clock resolves
  std::size_t times = 1;
  while (seconds_whole(times) < batch) times *= 2;
  std::array<double, 5> difference;
  for (double& one : difference)
    one = (seconds_whole(times) - seconds_halves(times)) / static_cast<double>(times);
  std::nth_element(difference.begin(), difference.begin() + difference.size() / 2, difference.end());
  return difference[difference.size() / 2];
}

}  // namespace superstep
