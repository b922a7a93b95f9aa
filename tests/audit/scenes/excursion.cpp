#include "audit/scenes/excursion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace superstep::audit {
namespace {

void add(TimeTable& table, double time, double value) {
  table.time.push_back(time);
  table.value.push_back(value);
}

/// From 0 to 1, beginning at the start or later.
Excursion ramp(Random& random, double t_end) {
  Excursion out;
  const bool at_once = random.uniform() < 0.3;
  const double begin = at_once ? 0 : t_end * random.uniform(0, 0.9);
  const double width = t_end * log_uniform(random, 1e-4, 1);
  add(out.shape, begin, 0);
  add(out.shape, begin + width, 1);
  return out;
}

/// One pulse, as short as 1e-5 of the run.
Excursion pulse(Random& random, double t_end) {
  Excursion out;
  const double width = t_end * log_uniform(random, 1e-5, 0.3);
  const double begin = random.uniform() * (t_end - width), rise = width * random.uniform(0.05, 0.3);
  add(out.shape, begin, 0);
  add(out.shape, begin + rise, 1);
  add(out.shape, begin + width - rise, 1);
  add(out.shape, begin + width, 0);
  out.inside = begin + 0.5 * width;
  return out;
}

/// On and off again and again.
Excursion heater(Random& random, double t_end) {
  Excursion out;
  const auto cycles = 2 + random.below(20);
  const double period = t_end / static_cast<double>(cycles), on = period * random.uniform(0.1, 0.8);
  const double rise = on * random.uniform(0.02, 0.3), first = (period - on) * random.uniform(0.05, 0.95);
  for (std::size_t k = 0; k < cycles; ++k) {
    const double begin = period * static_cast<double>(k) + first;
    add(out.shape, begin, 0);
    add(out.shape, begin + rise, 1);
    add(out.shape, begin + on - rise, 1);
    add(out.shape, begin + on, 0);
  }
  out.inside = period * static_cast<double>(cycles / 2) + first + 0.5 * on;
  return out;
}

/// What a logger writes: equal intervals, a slow swing and some noise.
Excursion profile(Random& random, double t_end, std::size_t most_points) {
  Excursion out;
  const auto points = 5 + random.below(most_points - 4);
  const double noise = random.uniform(0, 0.3), swings = random.uniform(0.3, 4), phase = random.uniform(0, 6);
  for (std::size_t k = 0; k <= points; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(points);
    const double swing = 0.5 + 0.5 * std::sin(2 * std::numbers::pi * swings * part + phase);
    add(out.shape, t_end * part, (1 - noise) * swing + noise * random.uniform());
  }
  return out;
}

/// Switched on for good, or on and off, without any rise time.
Excursion switched(Random& random, double t_end) {
  Excursion out;
  const double begin = t_end * random.uniform(0.01, 0.9);
  add(out.shape, begin, 0);
  add(out.shape, begin, 1);
  if (random.uniform() < 0.5) return out;
  const double width = (t_end - begin) * log_uniform(random, 1e-4, 0.9);
  add(out.shape, begin + width, 1);
  add(out.shape, begin + width, 0);
  out.inside = begin + 0.5 * width;
  return out;
}

/// A staircase of levels that hold for a while.
Excursion staircase(Random& random, double t_end) {
  Excursion out;
  const auto treads = 2 + random.below(8);
  double level = 0;
  for (std::size_t k = 1; k <= treads; ++k) {
    const double at = t_end * static_cast<double>(k) / static_cast<double>(treads + 1);
    add(out.shape, at, level);
    level = random.uniform();
    add(out.shape, at, level);
  }
  return out;
}

Excursion random_shape(Random& random, double t_end, bool steps, std::size_t most_points) {
  const double draw = random.uniform();
  if (steps && draw < 0.15) return switched(random, t_end);
  if (steps && draw < 0.25) return staircase(random, t_end);
  switch (random.below(4)) {
    case 0:
      return ramp(random, t_end);
    case 1:
      return pulse(random, t_end);
    case 2:
      return heater(random, t_end);
    default:
      return profile(random, t_end, most_points);
  }
}

/// Integral over [0, t_end]; end values hold outside the table.
double integral(const TimeTable& table, double t_end) {
  double sum = 0, t = 0, value = table.value.front();
  for (std::size_t k = 0; k < table.time.size() && t < t_end; ++k) {
    const double next = std::min(table.time[k], t_end), at_next = table.at(next);
    sum += 0.5 * (value + (next < table.time[k] ? at_next : table.value[k])) * (next - t);
    t = next;
    value = table.value[k];
  }
  return sum + value * std::max(0.0, t_end - t);
}

}  // namespace

TimeTable Excursion::between(double base, double peak) const {
  TimeTable table = shape;
  for (auto& value : table.value) value = base + (peak - base) * value;
  return table;
}

Excursion random_excursion(Random& random, double t_end, bool steps, std::size_t most_points) {
  Excursion out = random_shape(random, t_end, steps, most_points);
  out.active = integral(out.shape, t_end);
  return out;
}

double log_uniform(Random& random, double low, double high) {
  return low * std::exp(random.uniform() * std::log(high / low));
}

}  // namespace superstep::audit
