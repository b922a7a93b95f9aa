/// Scenes that once went wrong in silence (tests/trouble), under every adaptive method.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "bench/app/spec_settings.hpp"
#include "bench/harness/run_one.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

constexpr const char* scenes[] = {"pulse_source",     "switched_on",       "pulse_fixed",
                                  "pulse_ambient",    "heater_1hz",        "ramp_from_rest",
                                  "late_jump",        "pulse_electrode",   "pulse_steady_potential",
                                  "driven_potential", "joule_ramp_from_0", "joule_ramp_from_293",
                                  "hot_surroundings", "one_sphere_3000K",  "one_sphere_3000K_long"};

std::string folder() {
  return std::string(SUPERSTEP_SOURCE_DIR) + "/tests/trouble/";
}

/// Right values at t_end: field -> id -> value.
std::map<std::string, std::map<std::int64_t, double>> expected(const std::string& name) {
  std::ifstream file(folder() + name + "_expected.csv");
  std::string line, cell;
  std::getline(file, line);
  std::vector<std::string> header;
  for (std::istringstream cells(line); std::getline(cells, cell, ',');) header.push_back(cell);
  std::map<std::string, std::map<std::int64_t, double>> out;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::getline(cells, cell, ',');
    const std::int64_t id = std::stoll(cell);
    for (std::size_t k = 1; k < header.size() && std::getline(cells, cell, ','); ++k)
      out[header[k]][id] = std::stod(cell);
  }
  return out;
}

class Trouble : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(EveryScene, Trouble, ::testing::ValuesIn(scenes),
                         [](const auto& name) { return std::string(name.param); });

TEST_P(Trouble, IsRightUnderEveryAdaptiveMethod) {
  const Scene scene = load_scene(folder() + GetParam() + ".toml");
  const auto right = expected(GetParam());
  ASSERT_FALSE(right.empty());
  int measured = 0;
  for (const auto& entry : integrators()) {
    if (!entry.adaptive) continue;
    for (const double rtol : {1e-3, 1e-5}) {
      const std::string spec = with_tolerance(entry.name, rtol);
      std::vector<double> state;
      RunRequest request;
      request.observe = [&](std::size_t, double, std::span<const double> y) {
        state.assign(y.begin(), y.end());
      };
      const RunResult run = run_one(scene, spec, request);
      if (run.outcome.status == Status::refused) continue;
      ASSERT_TRUE(run.outcome.ok()) << spec << ": " << run.outcome.reason;
      for (std::size_t f = 0; f < scene.fields.size(); ++f) {
        const auto view = scene.fields[f].view;
        if (view < 0 || !right.contains(scene.fields[f].name)) continue;
        const auto values = scene.values_on_nodes(f, scene.t_end, state);
        const auto& ids = scene.fields[f].graph.id;
        double sum = 0;
        for (std::size_t k = 0; k < ids.size(); ++k) {
          const double difference = values[k] - right.at(scene.fields[f].name).at(ids[k]);
          sum += difference * difference;
        }
        const double span = run.spans[static_cast<std::size_t>(view)];
        // Three times what was asked for, and what the right values themselves are good for.
        EXPECT_LE(std::sqrt(sum / static_cast<double>(ids.size())), (3 * rtol + 1e-7) * span)
            << spec << ' ' << scene.fields[f].name << " of span " << span;
        ++measured;
      }
    }
  }
  EXPECT_GT(measured, 0);
}

}  // namespace
}  // namespace superstep
