#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "integrators/detail/exponential/chebyshev_exponential.hpp"

namespace superstep {

ExpansionScale find_expansion_scale(Rhs& rhs, double t, double elapsed, std::span<const double> y,
                                    double span, StateVector& work, StateVector& more_work) {
  const auto& facts = rhs.facts().fields.front();
  const bool constant = rhs.traits().autonomous;
  const auto capacity = rhs.capacities();
  const auto& reduction = rhs.reduction();
  const double total = reduction.sum([&](std::size_t i) { return capacity[i]; });
  const auto in_spans = [&](const auto& value) {
    const double sum = reduction.sum([&](std::size_t i) { return capacity[i] * value(i) * value(i); });
    return span > 0 ? std::sqrt(sum / total) / span : 0;
  };
  const auto entry = [](const StateVector& v) { return [&v](std::size_t i) { return v[i]; }; };
  ExpansionScale scale{.by_rate = facts.has_sources || !facts.ambient.empty() || !constant};
  if (span > 0) {
    const double mean = reduction.sum([&](std::size_t i) { return capacity[i] * y[i]; }) / total;
    std::fill(work.begin(), work.end(), mean);
    rhs(t, work, more_work);
    scale.deviation = in_spans([&](std::size_t i) { return y[i] - mean; });
    scale.uniform_rate = in_spans(entry(more_work));
  }
  if (!scale.by_rate) return scale;
  rhs(t, y, work);
  scale.rate = in_spans(entry(work));
  if (constant || !(elapsed > 0)) return scale;
  rhs(t + elapsed, y, more_work);
  for_each_entry(work.size(), [&](std::size_t i) { more_work[i] = (more_work[i] - work[i]) / elapsed; });
  scale.turn = in_spans(entry(more_work));
  return scale;
}

}  // namespace superstep
