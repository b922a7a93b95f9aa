#include "reports/chart/chart_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/round_marks.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

constexpr int most_decades = 7;                       // with a label each
constexpr double smallest = 1e-300, largest = 1e300;  // beyond, round numbers are no numbers any more

/// Labels of decades: all of them powers where there are many.
std::string decade_text(int power, bool many) {
  if (!many || (power >= 0 && power <= 1)) return number_text(std::pow(10.0, power), 1);
  return power_text(power);
}

}  // namespace

ChartScale::ChartScale(const ChartAxis& axis, double low, double high, double first, double last)
    : logarithmic_(axis.logarithmic),
      low_(axis.low.value_or(low)),
      high_(axis.high.value_or(high)),
      first_(first),
      last_(last) {
  if (logarithmic_)
    make_logarithmic(axis);
  else
    make_linear(axis);
}

void ChartScale::make_linear(const ChartAxis& axis) {
  const auto range = room_for_marks(low_, high_);
  low_ = range.low;
  high_ = range.high;
  const double step = round_step(high_ - low_);
  if (!axis.low) low_ = step * std::floor(low_ / step + 1e-9);
  if (!axis.high) high_ = step * std::ceil(high_ / step - 1e-9);
  for (const double value : round_marks(low_, high_, step)) ticks_.push_back({value, number_text(value, 4)});
}

void ChartScale::make_logarithmic(const ChartAxis& axis) {
  low_ = low_ > 0 ? std::clamp(low_, smallest, largest) : 1e-16;
  high_ = std::min(high_, largest);
  if (!(high_ > low_)) high_ = 10 * low_;
  const double decades = std::log10(high_) - std::log10(low_);
  if (decades < 1) {  // less than a decade: round numbers inside it
    low_ /= axis.low ? 1 : 1.15;
    high_ *= axis.high ? 1 : 1.15;
    for (const double value : round_marks(low_, high_, round_step(high_ - low_)))
      ticks_.push_back({value, number_text(value, 4)});
    return;
  }
  const int first = static_cast<int>(std::floor(std::log10(low_) + 1e-9));
  const int last = static_cast<int>(std::ceil(std::log10(high_) - 1e-9));
  if (!axis.low) low_ = std::pow(10.0, first);
  if (!axis.high) high_ = std::pow(10.0, last);
  const int stride = 1 + (last - first) / most_decades;
  for (int power = first; power <= last; ++power) {
    const double value = std::pow(10.0, power);
    if (value < low_ * (1 - 1e-9) || value > high_ * (1 + 1e-9)) continue;
    ticks_.push_back({value, (power - first) % stride == 0 ? decade_text(power, last - first > 4) : ""});
    if (last - first > 2) continue;
    for (int digit = 2; digit < 10; ++digit)
      if (digit * value <= high_)
        ticks_.push_back({digit * value, last - first == 1 && (digit == 2 || digit == 5)
                                             ? number_text(digit * value, 1)
                                             : ""});
  }
}

double ChartScale::position(double value) const noexcept {
  return logarithmic_ ? (std::log(value) - std::log(low_)) / (std::log(high_) - std::log(low_))
                      : (value - low_) / (high_ - low_);
}

bool ChartScale::shows(double value) const noexcept {
  if (!std::isfinite(value) || (logarithmic_ && !(value > 0))) return false;
  constexpr double slack = 1e-6;
  const double at = position(value);
  return at >= -slack && at <= 1 + slack;
}

double ChartScale::pixel(double value) const noexcept {
  return first_ + position(value) * (last_ - first_);
}

}  // namespace superstep
