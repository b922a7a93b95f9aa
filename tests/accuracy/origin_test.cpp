/// Where the zero of a temperature scale lies changes nothing that is a difference: not the steps, not the
/// work, not the error; and everything that is written is on the user's scale.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/measure/run_one.hpp"
#include "bench/output/run_files.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

/// Sixty-four spheres from rest: a source that is switched on and off, a fixed value and surroundings that
/// follow ramps with a step. `more` is for the thermal table.
std::string scene_text(double zero, const std::string& conductivity = "20.0", const std::string& more = "") {
  const auto at = [&](double value) { return fmt::format("{}", zero + value); };
  return fmt::format(
      "t_end = 4.0\noutput_times = [1.0, 2.0, 4.0]\nprobe = 30\n[packing]\ngenerator = \"grid\"\n"
      "length_unit = \"mm\"\ncount = 64\nspacing = 1.0\njitter = 0.02\nseed = 5\n"
      "sizes = {{ distribution = \"uniform\", min = 1.05, max = 1.1 }}\n[material]\ndensity = 7000.0\n"
      "[contact]\nneck = \"coble\"\n[thermal]\nconductivity = {}\nspecific_heat = 500.0\ninitial = {}\n"
      "fixed = [ {{ where = {{ ids = [0, 1, 2, 3] }}, value = {{ times = [0.0, 1.5, 1.5, 4.0], values = [{}, "
      "{}, {}, {}] "
      "}} }} ]\n"
      "source = [ {{ where = {{ ids = [60] }}, value = {{ times = [0.0, 0.5, 0.5, 2.5, 2.5], values = [0.0, "
      "0.0, 0.02, "
      "0.02, 0.0] }} }} ]\n"
      "convection = [ {{ where = \"all\", coefficient = 40.0, ambient = {{ times = [0.0, 3.0], values = [{}, "
      "{}] }} }} ]\n{}",
      conductivity, at(0), at(0), at(10), at(4), at(7), at(0), at(6), more);
}

struct Ran {
  RunResult result;
  std::vector<double> values;  ///< on nodes, at the end
};

Ran run(const Scene& scene, const MethodSpec& spec) {
  Ran out;
  RunRequest request;
  request.observe = [&](std::size_t, double t, std::span<const double> state) {
    out.values = scene.values_on_nodes(0, t, state);
  };
  out.result = run_one(scene, spec, request);
  return out;
}

class AnyZero : public testing::TestWithParam<const char*> {};

TEST_P(AnyZero, GivesTheSameStepsAndTheSameDifferences) {
  const test::CaseFolder folder;
  const Scene plain = load_scene(folder.write("a.toml", scene_text(0)));
  const Ran expected = run(plain, std::string(GetParam()));
  ASSERT_TRUE(expected.result.outcome.ok()) << expected.result.outcome.reason;
  for (const double zero : {273.15, -1000.0}) {
    const Scene moved = load_scene(folder.write("b.toml", scene_text(zero)));
    EXPECT_EQ(moved.fields[0].origin, zero > 0 ? zero : zero + 10) << "of what is fixed and starts";
    const Ran found = run(moved, std::string(GetParam()));
    ASSERT_TRUE(found.result.outcome.ok()) << found.result.outcome.reason;
    EXPECT_EQ(found.result.statistics.steps, expected.result.statistics.steps) << zero;
    EXPECT_EQ(found.result.statistics.rejected, expected.result.statistics.rejected) << zero;
    // At rest f is 0 on one scale and a rounding on another, which may cost the pilot run a stage.
    constexpr double a_stage = 1;
    EXPECT_NEAR(static_cast<double>(found.result.sweeps), static_cast<double>(expected.result.sweeps),
                a_stage)
        << zero;
    double worst = 0;
    for (std::size_t k = 0; k < found.values.size(); ++k)
      worst = std::max(worst, std::abs(found.values[k] - zero - expected.values[k]));
    EXPECT_LT(worst, 1e-10) << "some hundred roundings of a thousand, " << zero;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, AnyZero,
                         testing::Values("forward-euler", "sts:n=5,nu=1e-2", "rkc:rtol=1e-5", "rkl:rtol=1e-5",
                                         "rkg:rtol=1e-5", "trapezoidal:rtol=1e-4", "esdirk:rtol=1e-5",
                                         "cvode:rtol=1e-6", "exponential:basis=lanczos,rtol=1e-6"));

TEST(Origin, StaysAtZeroWhereTemperaturesThemselvesMatter) {
  const test::CaseFolder folder;
  const std::string law = "{ law = \"linear\", value = 20.0, coefficient = 1e-3, reference = 300.0 }";
  const std::string radiation = "radiation = [ { where = \"all\", emissivity = 0.8, ambient = 320.0 } ]\n";
  EXPECT_EQ(load_scene(folder.write("a.toml", scene_text(300, law))).fields[0].origin, 0);
  EXPECT_EQ(load_scene(folder.write("b.toml", scene_text(300, "20.0", radiation))).fields[0].origin, 0);
  EXPECT_EQ(load_scene(folder.write("c.toml", scene_text(300))).fields[0].origin, 300);
}

TEST(Origin, EverythingWrittenIsOnTheUsersScale) {
  const test::CaseFolder folder;
  const Scene scene = load_scene(folder.write("a.toml", scene_text(300)));
  const ProbeSet probes(scene);
  const RunResult result = run_one(scene, "rkc:rtol=1e-5", {.probes = &probes});
  ASSERT_TRUE(result.outcome.ok());
  const std::string csv = probes_csv(probes, result.history, scene.t_end);
  for (std::size_t at = csv.find('\n') + 1; at < csv.size(); at = csv.find('\n', at) + 1) {
    const double value = std::stod(csv.substr(csv.find(',', at) + 1));
    EXPECT_GE(value, 299.9);
    EXPECT_LE(value, 400.0);
  }
  EXPECT_EQ(scene.values_on_nodes(0, 0, scene.initial)[30], 300);
}

/// SUNDIALS' own tolerance is relative to |y|, and y is what the user calls it.
TEST(Origin, LocalTolerancesOfCvodeCountFromTheUsersZero) {
  const test::CaseFolder folder;
  const Scene cold = load_scene(folder.write("a.toml", scene_text(0))),
              warm = load_scene(folder.write("b.toml", scene_text(1000)));
  const auto steps = [](const Scene& scene, const char* spec) {
    return run(scene, spec).result.statistics.steps;
  };
  EXPECT_LT(steps(warm, "cvode:rtol=1e-6,tolerance=local"),
            0.8 * static_cast<double>(steps(cold, "cvode:rtol=1e-6,tolerance=local")));
  EXPECT_EQ(steps(warm, "cvode:rtol=1e-6"), steps(cold, "cvode:rtol=1e-6"));
}

/// A node without capacity takes the value that its neighbours give it; what its file says of its start must
/// not make tolerances looser, or the zero of the scale another.
TEST(Origin, WhereNodesWithoutCapacityStartSaysNothing) {
  const test::CaseFolder folder;
  folder.write("e.csv", "i,j,conductance\n0,1,1\n1,2,1\n0,3,1\n");
  const auto scene = [&](const char* start) {
    folder.write(
        "n.csv",
        fmt::format("id,capacity,source,initial,fixed\n0,1,0,300,\n1,0,0,{},\n2,1,0,300,310\n3,1,0,300,\n",
                    start));
    return load_scene(
        folder.write("c.toml", "t_end = 3.0\n[network]\nnodes = \"n.csv\"\nedges = \"e.csv\"\n"));
  };
  const Scene right = scene("300"), odd = scene("0"), wild = scene("-1e6");
  for (const Scene* one : {&odd, &wild}) {
    EXPECT_EQ(one->fields[0].low, 300);
    EXPECT_EQ(one->fields[0].high, 310);
    const Ran found = run(*one, "rkc:rtol=1e-3"), expected = run(right, "rkc:rtol=1e-3");
    EXPECT_EQ(found.result.spans, expected.result.spans);
    EXPECT_EQ(found.values, expected.values);
  }
}

}  // namespace
}  // namespace superstep
