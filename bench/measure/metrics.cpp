#include "bench/measure/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace superstep {
namespace {

constexpr double transient_threshold = 0.01;
constexpr double balance_rounding = 1e-12;
constexpr std::size_t fewest_points = 3;

// Calls visit(i) for every entry of the state that belongs to the field.
template <class Visit>
void for_entries(const FieldView& field, Visit visit) {
  for (std::size_t k = 0, i = field.offset; k < field.count; ++k, i += field.stride) visit(i);
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// Regression of y on x, both shifted to mean 0 first: t^2 of late instants would drown the rest.
std::optional<DecayFit> regress(std::vector<double> x, std::vector<double> y) {
  const double x_mean = mean(x), y_mean = mean(y);
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double dx = x[k] - x_mean, dy = y[k] - y_mean;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  if (!(xx > 0)) return std::nullopt;
  DecayFit fit{.rate = -xy / xx * std::numbers::ln10, .r2 = std::nullopt};
  if (yy > 0) fit.r2 = xy * xy / (xx * yy);
  return fit;
}

}  // namespace

Deviation deviation(const FieldView& field, std::span<const double> state,
                    std::span<const double> reference) {
  double sum = 0, largest = 0;
  for_entries(field, [&](std::size_t i) {
    const double difference = std::abs(state[i] - reference[i]);
    sum += difference * difference;
    largest = std::max(largest, difference);
  });
  return {std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, field.count))), largest};
}

double overshoot(const FieldView& field, std::span<const double> state, double low, double high) {
  double largest = 0;
  for_entries(field, [&](std::size_t i) { largest = std::max({largest, low - state[i], state[i] - high}); });
  return largest;
}

double stored(const FieldView& field, std::span<const double> capacities, std::span<const double> before,
              std::span<const double> now) {
  double sum = 0;
  for_entries(field, [&](std::size_t i) { sum += capacities[i] * (now[i] - before[i]); });
  return sum;
}

std::optional<double> balance(double entered, double stored, double scale) {
  if (!(std::abs(entered) > balance_rounding * scale)) return std::nullopt;
  return (entered - stored) / entered;
}

std::size_t transient_length(std::span<const double> distance, double largest) {
  std::size_t length = distance.size();
  while (length > 0 && !(distance[length - 1] > transient_threshold * largest)) --length;
  return length < fewest_points ? distance.size() : length;
}

std::optional<DecayFit> fit_decay(std::span<const double> time, std::span<const double> absolute_error) {
  std::vector<double> t, logarithm;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (!(absolute_error[k] > 0)) continue;
    t.push_back(time[k]);
    logarithm.push_back(std::log10(absolute_error[k]));
  }
  if (t.size() < fewest_points) return std::nullopt;
  return regress(std::move(t), std::move(logarithm));
}

}  // namespace superstep
