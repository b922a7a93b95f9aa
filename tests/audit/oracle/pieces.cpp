#include "audit/oracle/pieces.hpp"

#include <algorithm>

namespace superstep::audit {
namespace {

double right_value(const TimeTable& table, double t) {
  const auto after = std::upper_bound(table.time.begin(), table.time.end(), t);
  if (after == table.time.begin()) return table.value.front();
  const auto k = static_cast<std::size_t>(after - table.time.begin());
  if (after == table.time.end() || table.time[k - 1] == t) return table.value[k - 1];
  const double part = (t - table.time[k - 1]) / (table.time[k] - table.time[k - 1]);
  return table.value[k - 1] + part * (table.value[k] - table.value[k - 1]);
}

double left_value(const TimeTable& table, double t) {
  const auto from = std::lower_bound(table.time.begin(), table.time.end(), t);
  if (from == table.time.end()) return table.value.back();
  const auto k = static_cast<std::size_t>(from - table.time.begin());
  if (table.time[k] == t || k == 0) return table.value[k];
  const double part = (t - table.time[k - 1]) / (table.time[k] - table.time[k - 1]);
  return table.value[k - 1] + part * (table.value[k] - table.value[k - 1]);
}

}  // namespace

Line line_of(const TimeTable& table, double t0, double t1) {
  const double from = right_value(table, t0), to = left_value(table, t1);
  return {from, (to - from) / (t1 - t0)};
}

std::vector<double> knots(const StatedScene& scene, const std::vector<double>& further) {
  std::vector<double> times = {0, scene.t_end};
  const auto take = [&](double t) {
    if (t > 0 && t < scene.t_end) times.push_back(t);
  };
  for (const auto& field : scene.fields)
    for (const auto& table : field.graph.tables)
      for (const double t : table.time) take(t);
  for (const double t : further) take(t);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

std::vector<double> corner_times(const StatedScene& scene) {
  std::vector<double> corners, times;
  for (const auto& field : scene.fields)
    for (const auto& law : field.laws.of_material)
      corners.insert(corners.end(), law.temperatures.begin(), law.temperatures.end());
  for (const auto& field : scene.fields) {
    if (field.name != "temperature") continue;
    for (const auto& table : field.graph.tables)
      for (std::size_t k = 1; k < table.time.size(); ++k)
        for (const double corner : corners) {
          const double a = table.value[k - 1] - corner, b = table.value[k] - corner;
          if (a * b < 0)
            times.push_back(table.time[k - 1] + a / (a - b) * (table.time[k] - table.time[k - 1]));
        }
  }
  return times;
}

}  // namespace superstep::audit
