/// Outputs within a sliver of a step of a knot, and packages in surroundings that they did not expect.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "bench/measure/run_one.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

/// Touching spheres in a row, about a second between neighbours. One is heated by a ramp until 1 s and by
/// nothing from then on.
std::string write_ramp(const test::CaseFolder& folder) {
  std::string rows = "id,x,y,z,radius\n";
  for (int k = 0; k < 12; ++k) rows += fmt::format("{},0,0,{},0.5\n", k, 0.95 * k);
  folder.write("row.csv", rows);
  return folder.write(
      "ramp.toml",
      "t_end = 3.0\noutput_times = [1.0, 1.000000002, 1.000000004, 3.0]\n[packing]\nfile = "
      "\"row.csv\"\nlength_unit = \"mm\"\n[material]\ndensity = 2500.0\n[contact]\nneck = "
      "\"coble\"\n[thermal]\nconductivity = 1.0\nspecific_heat = 800.0\ninitial = 300.0\nsource "
      "= [ { where = { ids = [1] }, value = { times = [0.0, 1.0, 1.0], values = [0.0, 0.04, 0.0] } } "
      "]\nfixed = [ { where = { ids = [11] }, value = 300.0 } ]\n");
}

std::vector<std::vector<double>> states(const Scene& scene, const std::string& spec, Outcome& outcome) {
  std::vector<std::vector<double>> all;
  RunRequest request;
  request.observe = [&](std::size_t, double, std::span<const double> state) {
    all.emplace_back(state.begin(), state.end());
  };
  outcome = run_one(scene, spec, request).outcome;
  return all;
}

class BesideAKnot : public testing::TestWithParam<const char*> {};

TEST_P(BesideAKnot, EveryOutputIsRight) {
  const test::CaseFolder folder;
  const Scene scene = load_scene(write_ramp(folder));
  Outcome outcome;
  const auto right = states(scene, "exponential:rtol=1e-12", outcome);
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  for (const double rtol : {1e-3, 1e-6}) {
    const auto found = states(scene, fmt::format("{}rtol={}", GetParam(), rtol), outcome);
    if (outcome.status == Status::refused) GTEST_SKIP() << outcome.reason;
    ASSERT_TRUE(outcome.ok()) << outcome.reason;
    const auto [low, high] = std::minmax_element(right[0].begin(), right[0].end());
    const double span = *high - *low;
    for (std::size_t k = 0; k < right.size(); ++k)
      for (std::size_t i = 0; i < right[k].size(); ++i)
        EXPECT_NEAR(found[k][i], right[k][i], 3 * rtol * span) << rtol << ", output " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, BesideAKnot,
                         testing::Values("petsc:", "cvode:", "arkode:", "rkc:", "rock:", "rock:order=2,",
                                         "esdirk:", "trapezoidal:", "exprb:", "auto:"));

TEST(Surroundings, APackageNeedsNoFolderForTemporaryFiles) {
  const test::CaseFolder folder;
  const std::string rod = test::write_rod(folder, {});
  const Scene scene = load_scene(rod);
  Outcome outcome;
  (void)states(scene, "petsc", outcome);
  if (outcome.status == Status::refused) GTEST_SKIP() << outcome.reason;
  const std::string command =
      fmt::format("TMPDIR=/dev/null '{}' run '{}' --integrator petsc --out '{}' --quiet", SUPERSTEP_PROGRAM,
                  rod, folder.file("out"));
  EXPECT_EQ(std::system(command.c_str()), 0);  // NOLINT(cert-env33-c): a shell is what users have
}

}  // namespace
}  // namespace superstep
