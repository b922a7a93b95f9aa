#include "reports/gate/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/median.hpp"

namespace superstep {
namespace {

constexpr int resamples = 4000;
constexpr double tail = 0.005;

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

using Indices = std::vector<std::size_t>;

/// Logarithm of what the picked rounds say about work in units of the yardstick.
using Statistic = double (*)(const PairedTimings& timings, const Indices& rounds);

/// Slow phases that last longer than a round drop out of its quotient.
double median_of_quotients(const PairedTimings& timings, const Indices& rounds) {
  std::vector<double> logarithms;
  for (const std::size_t k : rounds) logarithms.push_back(std::log(timings.work[k] / timings.yardstick[k]));
  return median_of(std::move(logarithms));
}

/// Slow phases shorter than a round hit few of the faster runs.
double quotient_of_lower_quartiles(const PairedTimings& timings, const Indices& rounds) {
  const auto lower_quartile = [&](const std::vector<double>& times) {
    std::vector<double> picked;
    for (const std::size_t k : rounds) picked.push_back(times[k]);
    const auto quarter = picked.begin() + static_cast<std::ptrdiff_t>(picked.size() / 4);
    std::nth_element(picked.begin(), quarter, picked.end());
    return *quarter;
  };
  return std::log(lower_quartile(timings.work) / lower_quartile(timings.yardstick));
}

RatioInterval interval(Statistic statistic, const PairedTimings& now, const PairedTimings& before) {
  Draws draws;
  Indices a(now.rounds()), b(before.rounds());
  std::iota(a.begin(), a.end(), std::size_t{0});
  std::iota(b.begin(), b.end(), std::size_t{0});
  const double estimate = statistic(now, a) - statistic(before, b);
  std::vector<double> shifts;
  for (int k = 0; k < resamples; ++k) {
    for (auto& round : a) round = draws.below(now.rounds());
    for (auto& round : b) round = draws.below(before.rounds());
    shifts.push_back(statistic(now, a) - statistic(before, b));
  }
  std::sort(shifts.begin(), shifts.end());
  const auto last = static_cast<double>(resamples - 1);
  return {std::exp(estimate), std::exp(shifts[static_cast<std::size_t>(std::floor(tail * last))]),
          std::exp(shifts[static_cast<std::size_t>(std::ceil((1 - tail) * last))])};
}

}  // namespace

RatioInterval slowdown(const PairedTimings& now, const PairedTimings& before) {
  const auto medians = interval(median_of_quotients, now, before);
  const auto quartiles = interval(quotient_of_lower_quartiles, now, before);
  const auto width = [](const RatioInterval& ratio) { return ratio.high / ratio.low; };
  return width(quartiles) < width(medians) ? quartiles : medians;
}

RatioInterval against_itself(const PairedTimings& timings) {
  PairedTimings halves[2];
  for (std::size_t k = 0; k < timings.rounds(); ++k) {
    halves[k % 2].work.push_back(timings.work[k]);
    halves[k % 2].yardstick.push_back(timings.yardstick[k]);
  }
  return slowdown(halves[0], halves[1]);
}

}  // namespace superstep
