/// Krylov spaces on networks whose conductances and capacities differ by orders of magnitude from place to
/// place: there estimates of the error were seen to be ten times too small.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bench/harness/reference.hpp"
#include "bench/harness/verification.hpp"
#include "bench/measure/run_one.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

class UnevenNetwork : public testing::TestWithParam<const char*> {};

TEST_P(UnevenNetwork, LanczosKeepsItsTolerance) {
  const Scene scene = load_scene(fmt::format("{}/cases/corpus/{}.toml", SUPERSTEP_SOURCE_DIR, GetParam()));
  const ProbeSet probes(scene);
  Progress silent(false);
  ReferenceRequest request;
  request.use_cache = false;
  const auto found = obtain_reference(scene, probes, request, silent);
  ASSERT_TRUE(found.reference) << found.outcome.reason;
  for (const double rtol : {1e-2, 1e-4}) {
    const auto run = verify(scene, probes, fmt::format("exponential:basis=lanczos,rtol={}", rtol),
                            &*found.reference, nullptr, nullptr, {});
    ASSERT_TRUE(run.outcome.ok()) << run.outcome.reason;
    constexpr double most = 3;  // what any method may miss its tolerance by
    EXPECT_LT(run.errors.front().delivered.value(), most) << rtol;
  }
}

/// Three nodes that heat each other within 1e-17 s of the 0.01 s of the run, held by nothing, or by a path
/// that carries a billionth of a watt a kelvin: what assembled matrices know of them is below their
/// roundings.
class HiddenBySpeed : public testing::TestWithParam<double> {};

Scene write_network(const test::CaseFolder& folder, double t_end, const std::string& nodes,
                    const std::string& edges) {
  folder.write("nodes.csv", "id,capacity,source,initial,fixed\n" + nodes);
  folder.write("edges.csv", "i,j,conductance\n" + edges);
  return load_scene(folder.write(
      "case.toml",
      fmt::format("t_end = {}\n[network]\nnodes = \"nodes.csv\"\nedges = \"edges.csv\"\n", t_end)));
}

TEST_P(HiddenBySpeed, WhatIsSlowIsRight) {
  const double capacity = GetParam(), heat = 1.002, path = 1e-9, t_end = 0.01, held = 300;
  const test::CaseFolder folder;
  const auto last = [&](const std::string& nodes, const std::string& edges, const std::string& spec) {
    const Scene scene = write_network(folder, t_end, nodes, edges);
    EXPECT_EQ(capacity < 1e-10, !scene.warnings.empty() &&
                                    scene.warnings.front().find("roundings may hide") != std::string::npos);
    double value = 0;
    RunRequest request;
    request.observe = [&](std::size_t, double, std::span<const double> state) { value = state.front(); };
    const RunResult run = run_one(scene, spec, request);
    EXPECT_TRUE(run.outcome.ok()) << spec << ": " << run.outcome.reason;
    return value;
  };
  const std::string three = fmt::format("0,{0},0.001,0,\n1,{0},1,300,\n2,{0},0.001,-5,\n", capacity);
  const double rate = path / (3 * capacity);
  const double free = (heat * t_end + 295 * capacity) / (3 * capacity);
  const double bound =
      held + (295.0 / 3 - held) * std::exp(-rate * t_end) - heat / path * std::expm1(-rate * t_end);
  for (const char* spec : {"auto", "auto:rtol=1e-8", "exponential:basis=shift-invert", "cvode:rtol=1e-8"}) {
    EXPECT_NEAR(last(three, "0,1,1e6\n1,2,2.5e6\n", spec) / free, 1, 1e-6) << spec;
    EXPECT_NEAR(last(three + "3,1,0,300,300\n", "0,1,1e6\n1,2,2.5e6\n2,3,1e-9\n", spec) / bound, 1, 1e-6)
        << spec;
  }
}

INSTANTIATE_TEST_SUITE_P(Capacities, HiddenBySpeed, testing::Values(1e-9, 1e-11, 1e-12));

/// Only a part of the network floats: what holds the rest does not help it.
TEST(HiddenParts, APairBesideAHeldOneIsRightToo) {
  const test::CaseFolder folder;
  const Scene scene = write_network(folder, 2.8e16, "0,1,0,5,7\n1,1,0,5,\n2,1,0,1,\n3,1,0,4,\n4,1,0,1,\n",
                                    "0,1,1\n2,3,1\n3,4,1\n");
  std::vector<double> last;
  RunRequest request;
  request.observe = [&](std::size_t, double, std::span<const double> state) {
    last.assign(state.begin(), state.end());
  };
  for (const char* spec : {"auto:rtol=1e-3", "auto:rtol=1e-6"}) {
    const RunResult run = run_one(scene, spec, request);
    ASSERT_TRUE(run.outcome.ok()) << spec << ": " << run.outcome.reason;
    const auto values = scene.values_on_nodes(0, scene.t_end, last);
    for (const auto& [node, right] : {std::pair<std::size_t, double>{1, 7}, {2, 2}, {3, 2}, {4, 2}})
      EXPECT_NEAR(values[node], right, 1e-3) << spec << ' ' << node;
  }
}

/// Rates of 1e41 1/s: CVODE goes round in one step, and nobody but us would ever end it.
TEST(HiddenParts, APackageThatGoesRoundIsEnded) {
  const test::CaseFolder folder;
  const Scene scene = write_network(folder, 1e-3, "0,5.2e-35,0.001,0,\n1,1e-30,1,300,\n2,9.1e-30,0.001,-5,\n",
                                    "0,1,1.09e6\n1,2,2.53e6\n");
  for (const double limit : {0.0, 2.0})  // s; 0 = none
    for (const char* spec : {"cvode:rtol=1e-2", "auto"}) {
      RunRequest request;
      request.limits.seconds = limit;
      const RunResult run = run_one(scene, spec, request);
      EXPECT_TRUE(run.outcome.ok() || !run.outcome.reason.empty()) << spec;
    }
}

INSTANTIATE_TEST_SUITE_P(Corpus, UnevenNetwork, testing::Values("two_materials_1000", "fibres_1000"));

}  // namespace
}  // namespace superstep
