#include "bench/measure/joule_cost.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bench/harness/harness.hpp"
#include "bench/measure/run_one.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

using test::CaseFolder;

/// Six touching spheres in a row; `mode` and further keys of the electric field.
std::string write_row(const CaseFolder& folder, const std::string& mode) {
  std::string rows = "id,x,y,z,radius\n";
  for (int k = 0; k < 6; ++k) rows += fmt::format("{},0,0,{},0.5\n", k, 0.95 * k);
  folder.write("row.csv", rows);
  return folder.write(
      "row.toml",
      fmt::format("t_end = 1e-3\n[packing]\nfile = \"row.csv\"\nlength_unit = \"mm\"\n[material]\n"
                  "density = 5000.0\n[contact]\nneck = \"coble\"\n[electric]\n{}\nconductivity = 1e5\n"
                  "fixed = [ {{ where = {{ ids = [5] }}, value = 1.0 }}, {{ where = {{ ids = [0] }}, value = "
                  "0.0 }} ]\n[thermal]\nconductivity = 50.0\nspecific_heat = 500.0\n[bench]\n"
                  "baseline = \"forward-euler\"\nintegrators = [\"sts:n=5,nu=0.01\"]\n",
                  mode));
}
const std::string transient = "mode = \"transient\"\nspecific_capacity = 2e6\nsettle_tolerance = 1e-6";

std::vector<double> final_state(const Scene& scene, const std::string& spec) {
  std::vector<double> last;
  RunRequest request;
  request.observe = [&](std::size_t, double, std::span<const double> state) {
    last.assign(state.begin(), state.end());
  };
  EXPECT_TRUE(run_one(scene, spec, request).outcome.ok());
  return last;
}

TEST(JouleCost, IsMeasuredWhereCurrentHeatsAndNothingLeadsBack) {
  const CaseFolder folder;
  const Scene both = load_scene(write_row(folder, transient));
  ASSERT_EQ(both.rhs->fields().size(), 2U);
  const auto cost = JouleCost(both).sample();
  ASSERT_TRUE(cost);
  EXPECT_TRUE(std::isfinite(*cost));  // its size is a matter of the machine
}

TEST(JouleCost, IsNothingElsewhere) {
  const CaseFolder folder;
  EXPECT_FALSE(JouleCost(load_scene(write_row(folder, "mode = \"steady\""))).sample());
  EXPECT_FALSE(JouleCost(load_scene(write_rod(folder, {}))).sample());
}

TEST(JouleCost, LeavesTheSceneAsItWas) {
  const CaseFolder folder;
  const Scene scene = load_scene(write_row(folder, transient));
  const auto before = final_state(scene, "sts:n=5,nu=0.01");  // the potential has settled by its end
  (void)JouleCost(scene).sample();
  EXPECT_EQ(final_state(scene, "sts:n=5,nu=0.01"), before);
}

TEST(JouleCost, IsPartOfTheBenchmark) {
  const CaseFolder folder;
  const Scene scene = load_scene(write_row(folder, transient));
  Progress silent(false);
  const HarnessOptions options{
      .integrators = {}, .reference = "none", .use_cache = false, .repetitions = 2, .sampled = {}};
  EXPECT_TRUE(bench_case(scene, 0, options, silent).cpu_joule);
}

}  // namespace
}  // namespace superstep
