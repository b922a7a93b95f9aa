#pragma once
/// What is known about a right-hand side before it is integrated: plain values, computed once.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace superstep {

/// Smallest and largest value of a field [K or V].
struct FieldRange {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  [[nodiscard]] bool empty() const noexcept { return low > high; }
  [[nodiscard]] double span() const noexcept { return empty() ? 0 : high - low; }
  [[nodiscard]] double magnitude() const noexcept {
    return empty() ? 0 : std::max(std::abs(low), std::abs(high));
  }
  void take(double value) noexcept {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void take(const FieldRange& other) noexcept {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

constexpr std::size_t most_fields = 2;

/// An instant at which an input is not smooth: a knot of a table, or a step.
struct Breakpoint {
  double t = 0;  ///< s
  /// [fields] rms over the rows of what f changes by at once [K/s or V/s], and its slope in time [K/s2 or
  /// V/s2]; estimates where the input acts through a product.
  std::array<double, most_fields> jump{}, kink{};
};

/// Of one field.
struct FieldFacts {
  bool has_sources = false;    ///< Joule heat counts
  std::uint64_t nonzeros = 0;  ///< of the field's block of J off its diagonal, here and elsewhere
  /// Largest |rate| that sources alone can cause [K/s or V/s]: how fast the range may widen that the maximum
  /// principle allows; infinity when nothing bounds it beforehand.
  double source_rate = 0;
  FieldRange ambient;  ///< of convection and radiation, tables included; empty where there is none
};

/// What the maximum principle allows a field after `elapsed` [s]: declared values and surroundings, widened
/// by what sources can add.
inline FieldRange attainable_range(const FieldRange& declared, const FieldFacts& facts, double elapsed) {
  FieldRange range = declared;
  range.take(facts.ambient);
  const double widened = elapsed > 0 && facts.source_rate > 0 ? facts.source_rate * elapsed : 0;
  range.low -= widened;
  range.high += widened;
  return range;
}

struct RhsFacts {
  std::vector<FieldFacts> fields;
  /// Pairwise critical step with particle contributions only, the one that the source paper's alpha refers to
  /// [s].
  double pair_step = std::numeric_limits<double>::infinity();
  bool radiates = false;
  std::vector<Breakpoint> breakpoints;  ///< ascending; those closer than rounding are one
};

/// Sorts breakpoints and makes those one that differ by rounding only. Those at which nothing changes are
/// dropped.
inline void merge_breakpoints(std::vector<Breakpoint>& points) {
  const auto nothing = [](const Breakpoint& p) {
    return std::all_of(p.jump.begin(), p.jump.end(), [](double x) { return x == 0; }) &&
           std::all_of(p.kink.begin(), p.kink.end(), [](double x) { return x == 0; });
  };
  std::erase_if(points, nothing);
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  std::vector<Breakpoint> merged;
  for (const auto& point : points) {
    if (merged.empty() || point.t - merged.back().t > rounding * std::abs(point.t)) {
      merged.push_back(point);
      continue;
    }
    for (std::size_t f = 0; f < most_fields; ++f) {
      merged.back().jump[f] += point.jump[f];
      merged.back().kink[f] += point.kink[f];
    }
  }
  points = std::move(merged);
}

}  // namespace superstep
