#include "integrators/detail/krylov/residual_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace superstep {
namespace {

// g * longest: from 0.5, where exp(-sT) has hardly begun to fall, to as many as there may be vectors. Between
// two neighbours the bound is loose by some ten per cent where results have six digits.
constexpr double least = 0.5, ratio = 1.3;
constexpr int rates = 44;

}  // namespace

ResidualBound::ResidualBound(double longest) : pivot_(rates), log_transform_(rates, 0.0) {
  double rate = least / longest;
  for (int k = 0; k < rates; ++k, rate *= ratio) rate_.push_back(rate);
}

void ResidualBound::add_row(double alpha, double beta) {
  const bool first = rows_++ == 0;
  for (std::size_t k = 0; k < rate_.size(); ++k) {
    const double shifted = rate_[k] + alpha;
    // Never below g in exact arithmetic; rounding must not make it smaller.
    const double pivot = first ? shifted : std::max(rate_[k], shifted - beta * beta / pivot_[k]);
    log_transform_[k] += std::log((first ? 1 : beta) / pivot);
    pivot_[k] = pivot;
  }
}

double ResidualBound::log_integral(double t) const {
  double least_bound = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < rate_.size(); ++k) {
    const double gt = rate_[k] * t;
    const double largest = gt >= 1 ? gt - 1 - std::log(rate_[k]) : std::log(t);
    least_bound = std::min(least_bound, log_transform_[k] + largest);
  }
  return least_bound;
}

}  // namespace superstep
