#include <cmath>

#include "core/parallel.hpp"
#include "integrators/detail/exponential/chebyshev_exponential.hpp"

namespace superstep {

ExpansionScale find_expansion_scale(Rhs& rhs, double t, double elapsed, std::span<const double> y,
                                    double span, StateVector& work, StateVector& more_work) {
  const auto& facts = rhs.facts().fields.front();
  const bool constant = rhs.traits().autonomous;
  if (!facts.has_sources && facts.ambient.empty() && constant) return {};
  const auto capacity = rhs.capacities();
  const double total = rhs.reduction().sum([&](std::size_t i) { return capacity[i]; });
  const auto in_spans = [&](const StateVector& rate) {
    const double sum = rhs.reduction().sum([&](std::size_t i) { return capacity[i] * rate[i] * rate[i]; });
    return span > 0 ? std::sqrt(sum / total) / span : 0;
  };
  rhs(t, y, work);
  ExpansionScale scale{.by_rate = true, .rate = in_spans(work)};
  if (constant || !(elapsed > 0)) return scale;
  rhs(t + elapsed, y, more_work);
  for_each_entry(work.size(), [&](std::size_t i) { more_work[i] = (more_work[i] - work[i]) / elapsed; });
  scale.turn = in_spans(more_work);
  return scale;
}

}  // namespace superstep
