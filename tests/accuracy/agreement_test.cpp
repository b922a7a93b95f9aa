/// The same answers from all methods, on every case file.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "bench/measure/metrics.hpp"
#include "bench/measure/run_one.hpp"
#include "case/scene.hpp"
#include "core/text/toml.hpp"
#include "integrators/registry.hpp"
#include "rhs/one_way.hpp"

namespace superstep {
namespace {

std::vector<std::string> case_files() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(SUPERSTEP_SOURCE_DIR) + "/cases"))
    // Moving particles have answers of their own: tests/dynamics.
    // The scene of nial_thermal.toml under other methods: tests/accuracy/paper_case_test.cpp.
    // The beginning of nial_thermoelectric.toml, up to the same first output.
    if (entry.path().extension() == ".toml" && entry.path().stem() != "nial_thermal_paper" &&
        entry.path().stem() != "nial_thermoelectric_daily" &&
        !TomlTable::parse_file(entry.path().string()).find("dynamics"))
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

constexpr std::size_t large = 10'000;  // unknowns; such a case is run up to its first output time

/// States at the output times; empty when the method did not end well.
std::vector<std::vector<double>> states(const Scene& scene, const std::string& spec,
                                        const std::vector<double>& spans) {
  std::vector<std::vector<double>> out;
  RunRequest request{.spans = spans};
  request.observe = [&](std::size_t, double, std::span<const double> state) {
    out.emplace_back(state.begin(), state.end());
  };
  const RunResult run = run_one(scene, spec, request);
  EXPECT_TRUE(run.outcome.ok() || (run.outcome.status == Status::refused && !run.outcome.reason.empty()))
      << spec << ": " << run.outcome.reason;
  return out;
}

/// Span of a field [K or V]: what it starts from and is held at, and what the reference computed.
double span_of(const Scene& scene, const FieldView& field,
               const std::vector<std::vector<double>>& reference) {
  const auto& described = scene_field(scene, field.name);
  double low = described.low, high = described.high;
  for (const auto& state : reference)
    for (std::size_t i = field.offset; i < field.offset + field.count; ++i) {
      low = std::min(low, state[i]);
      high = std::max(high, state[i]);
    }
  return high - low;
}

class EveryCase : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Cases, EveryCase, ::testing::ValuesIn(case_files()),
                         [](const auto& file) { return std::filesystem::path(file.param).stem().string(); });

TEST_P(EveryCase, HasOneAnswer) {
  Scene scene = load_scene(GetParam());
  const bool is_large = scene.rhs->size() > large;
  if (is_large) {
    scene.output_times.resize(1);
    scene.t_end = scene.output_times.front();
  }
  const auto spans = scene_spans(scene).spans;
  const auto reference =
      states(scene, exactly_solvable(*scene.rhs) ? "exponential:rtol=1e-13" : "cvode:rtol=1e-9", spans);
  constexpr double rtol = 1e-4;
  for (const auto& entry : integrators()) {
    // Adaptive methods at one tolerance; those without one at their finest usual step.
    const std::string spec = entry.adaptive        ? entry.name + ":rtol=1e-4"
                             : entry.name == "sts" ? "sts:n=5,nu=0.05"
                                                   : entry.name;
    // The same matrices as trapezoidal's, five times a step: minutes on a large scene.
    if (is_large && entry.name == "esdirk") continue;
    const auto result = states(scene, spec, spans);
    if (result.empty()) continue;  // refused, with a reason
    ASSERT_EQ(result.size(), reference.size()) << spec;
    double worst = 0;
    for (const auto& field : scene.rhs->fields())
      for (std::size_t k = 0; k < result.size(); ++k)
        worst =
            std::max(worst, deviation(field, result[k], reference[k]).rms / span_of(scene, field, reference));
    // Local control adds up to some times rtol; first-order fixed steps are as good as a fraction of the
    // first output.
    EXPECT_LT(worst, entry.adaptive ? 10 * rtol : 5e-2) << spec;
  }
}

}  // namespace
}  // namespace superstep
