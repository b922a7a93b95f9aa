#include "reports/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace superstep {
namespace {

constexpr int resamples = 4000;
constexpr double tail = 0.005;

double median(std::vector<double>& values) {
  const auto n = static_cast<std::ptrdiff_t>(values.size());
  std::nth_element(values.begin(), values.begin() + n / 2, values.end());
  const double upper = values[static_cast<std::size_t>(n / 2)];
  if (n % 2 == 1) return upper;
  return 0.5 * (upper + *std::max_element(values.begin(), values.begin() + n / 2));
}

class Draws {
 public:
  std::size_t below(std::size_t n) noexcept {
    state_ ^= state_ << 13;  // xorshift64
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<std::size_t>(state_ >> 33) % n;
  }

 private:
  std::uint64_t state_ = 0x9E3779B97F4A7C15u;
};

std::vector<double> logarithms(const PairedTimings& timings) {
  std::vector<double> out;
  for (std::size_t k = 0; k < timings.rounds(); ++k)
    out.push_back(std::log(timings.work[k] / timings.yardstick[k]));
  return out;
}

RatioInterval interval(const std::vector<double>& now, const std::vector<double>& before) {
  Draws draws;
  std::vector<double> a = now, b = before, shifts;
  const double estimate = median(a) - median(b);
  for (int k = 0; k < resamples; ++k) {
    for (double& value : a) value = now[draws.below(now.size())];
    for (double& value : b) value = before[draws.below(before.size())];
    shifts.push_back(median(a) - median(b));
  }
  std::sort(shifts.begin(), shifts.end());
  const auto last = static_cast<double>(resamples - 1);
  return {std::exp(estimate), std::exp(shifts[static_cast<std::size_t>(std::floor(tail * last))]),
          std::exp(shifts[static_cast<std::size_t>(std::ceil((1 - tail) * last))])};
}

}  // namespace

RatioInterval slowdown(const PairedTimings& now, const PairedTimings& before) {
  return interval(logarithms(now), logarithms(before));
}

RatioInterval against_itself(const PairedTimings& timings) {
  std::vector<double> halves[2];
  const auto all = logarithms(timings);
  for (std::size_t k = 0; k < all.size(); ++k) halves[k % 2].push_back(all[k]);
  return interval(halves[0], halves[1]);
}

}  // namespace superstep
