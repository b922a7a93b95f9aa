#include "audit/oracle/oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "audit/oracle/linear_truth.hpp"
#include "audit/oracle/radau.hpp"

namespace superstep::audit {
namespace {

bool follows_temperature(const FieldScene& field) {
  return std::any_of(field.laws.of_material.begin(), field.laws.of_material.end(),
                     [](const auto& law) { return law.varies(); });
}

/// Largest difference of two runs over all nodes and output times, field by field.
std::vector<double> differences(const RadauRun& a, const RadauRun& b) {
  std::vector<double> largest(a.values.size(), 0.0);
  for (std::size_t f = 0; f < largest.size(); ++f)
    for (std::size_t k = 0; k < a.values[f].size(); ++k)
      for (std::size_t node = 0; node < a.values[f][k].size(); ++node)
        largest[f] = std::max(largest[f], std::abs(a.values[f][k][node] - b.values[f][k][node]));
  return largest;
}

std::vector<double> spans(const RadauRun& run) {
  std::vector<double> out;
  for (std::size_t f = 0; f < run.low.size(); ++f) out.push_back(run.high[f] - run.low[f]);
  return out;
}

Truth stepped_truth(const StatedScene& scene, const OracleSettings& settings) {
  const auto scale = spans(integrate_by_radau(scene, 1e-4, {}));
  // The estimate is of order 5, the method of order 9: its error is about the estimate to the power 10/6.
  double tolerance = 1e-7;
  RadauRun coarse = integrate_by_radau(scene, tolerance, scale);
  for (int attempt = 0; attempt < 4; ++attempt) {
    tolerance *= 0.03;
    RadauRun fine = integrate_by_radau(scene, tolerance, scale);
    const auto error = differences(coarse, fine);
    bool agree = true;
    for (std::size_t f = 0; f < error.size(); ++f) {
      const double rounding = 20 * std::numeric_limits<double>::epsilon() *
                              std::max(std::abs(fine.low[f]), std::abs(fine.high[f]));
      agree = agree && error[f] <= std::max(settings.accuracy * scale[f], rounding);
    }
    if (agree) {
      Truth truth;
      truth.steps = fine.steps;
      for (std::size_t f = 0; f < error.size(); ++f)
        truth.fields.push_back(
            {scene.fields[f].name, std::move(fine.values[f]), fine.low[f], fine.high[f], error[f]});
      return truth;
    }
    coarse = std::move(fine);
  }
  throw std::runtime_error("the oracle's runs do not agree");
}

}  // namespace

double FieldTruth::size() const noexcept {
  return std::max(std::abs(low), std::abs(high));
}

bool is_linear(const StatedScene& scene) {
  for (const auto& field : scene.fields)
    if (follows_temperature(field) || !field.graph.radiation.empty()) return false;
  if (scene.fields.size() < 2) return true;
  const auto& electric = scene.fields.front();
  return !scene.coupling.joule_heat || (electric.steady && electric.graph.tables.empty());
}

Truth find_truth(const StatedScene& scene, const OracleSettings& settings) {
  return is_linear(scene) && !settings.by_steps ? linear_truth(scene) : stepped_truth(scene, settings);
}

}  // namespace superstep::audit
