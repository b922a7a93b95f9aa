#include "bench/measure/sampled_errors.hpp"

#include <cmath>

#include "bench/measure/metrics.hpp"

namespace superstep {
namespace {

constexpr double rounding_share = 1e-9;  // of the interval between two instants: sums of steps round

bool covers(const ProbeHistory& history, std::span<const double> instants, double rounding) {
  return !instants.empty() && history.size() > 0 &&
         history.time(history.size() - 1) >= instants.back() - rounding;
}

}  // namespace

std::vector<double> sampling_instants(const SampledMeasure& measure) {
  const auto last = static_cast<int>(std::lround((measure.to - measure.from) / measure.every));
  std::vector<double> instants;
  for (int k = 0; k <= last; ++k) instants.push_back(measure.from + k * measure.every);
  return instants;
}

std::vector<double> written_values(const ProbeHistory& history, std::size_t slot,
                                   std::span<const double> instants, double rounding) {
  std::vector<double> values;
  if (!covers(history, instants, rounding)) return values;
  std::size_t step = 0;
  for (const double instant : instants) {
    while (history.time(step) < instant - rounding) ++step;
    values.push_back(history.value(step, slot));
  }
  return values;
}

std::vector<double> values_at(const ProbeHistory& history, std::size_t slot, std::span<const double> instants,
                              double rounding) {
  std::vector<double> values;
  if (!covers(history, instants, rounding)) return values;
  for (const double instant : instants) values.push_back(history.at(instant, slot));
  return values;
}

void measure_samples(std::span<const double> instants, std::span<const double> values,
                     std::span<const double> subtracted, FieldErrors& errors) {
  std::vector<double> difference;
  double sum = 0;
  for (std::size_t k = 0; k < instants.size(); ++k) {
    difference.push_back(std::abs(values[k] - subtracted[k]));
    sum += difference.back();
  }
  errors.published_mean = sum / static_cast<double>(instants.size());
  if (const auto fit = fit_decay(instants, difference)) {
    errors.published_rate = fit->rate;
    errors.published_r2 = fit->r2;
  }
}

SampledErrors::SampledErrors(const std::optional<SampledMeasure>& measure, const ProbeSet& probes) {
  if (!measure) return;
  const ProbeColumn* probe = probes.first_in(measure->field);
  if (!probe) return;
  measure_ = measure;
  instants_ = sampling_instants(*measure);
  slot_ = static_cast<std::size_t>(probe->slot);
}

std::vector<double> SampledErrors::samples(const ProbeHistory& history) const {
  if (!measure_) return {};
  const double rounding = rounding_share * measure_->every;
  return measure_->as_written ? written_values(history, slot_, instants_, rounding)
                              : values_at(history, slot_, instants_, rounding);
}

void SampledErrors::measure(std::span<const double> samples, std::span<const double> subtracted,
                            FieldErrors& errors) const {
  if (samples.empty() || subtracted.empty()) return;
  measure_samples(instants_, samples, subtracted, errors);
}

}  // namespace superstep
