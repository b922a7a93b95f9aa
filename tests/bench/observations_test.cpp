#include "bench/harness/observations.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/harness/harness.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

using test::CaseFolder;

// Three spheres on the mid-plane of y, two off it.
std::string write_spheres(const CaseFolder& folder, const std::string& bench, double conductivity = 0.001) {
  folder.write("spheres.csv",
               "id,x,y,z,radius\n1,0,0,0,0.51\n2,0,0,1,0.51\n3,0,0,2,0.51\n4,0,1,1,0.51\n5,0,-1,1,0.51\n");
  return folder.write("spheres.toml",
                      fmt::format("t_end = 1000\noutput_times = [100, 1000]\nprobe = 2\n[packing]\n"
                                  "file = \"spheres.csv\"\n[material]\ndensity = 1\n[contact]\n"
                                  "neck = \"geometric\"\n[thermal]\nconductivity = {}\nspecific_heat = 1\n"
                                  "initial = 0\nfixed = [{{ where = {{ ids = [1] }}, value = 0.0 }}, "
                                  "{{ where = {{ ids = [3] }}, value = 10.0 }}]\n[bench]\n{}",
                                  conductivity, bench));
}

BenchCase bench(const std::string& file, const std::string& reference) {
  const Scene scene = load_scene(file);
  Progress silent(false);
  HarnessOptions options;
  options.reference = reference;
  options.use_cache = false;
  options.repetitions = 1;
  return bench_case(scene, 0.01, options, silent);
}

TEST(Observations, HoldCurvesWithTheReferenceAndASlice) {
  const CaseFolder folder;
  const BenchCase one =
      bench(write_spheres(folder, "integrators = [\"cvode:rtol=1e-6\"]\n"), "cvode:rtol=1e-9");
  ASSERT_EQ(one.observations.curves.size(), 2U) << "cvode and the baseline";
  for (const auto& curve : one.observations.curves) {
    ASSERT_EQ(curve.reference.size(), curve.time.size());
    EXPECT_EQ(curve.probe, "2");
    EXPECT_EQ(curve.time.front(), 0);
    EXPECT_GT(curve.transient, 0U);
    // No step end was left out here, so the mean error over the curve's transient is the one of the table;
    // the initial state, which has none, does not count there.
    double sum = 0;
    for (std::size_t k = 1; k < curve.transient; ++k) sum += std::abs(curve.value[k] - curve.reference[k]);
    const auto row =
        std::find_if(one.rows.begin(), one.rows.end(), [&](const auto& r) { return r.spec == curve.spec; });
    ASSERT_NE(row, one.rows.end());
    EXPECT_NEAR(sum / static_cast<double>(curve.transient - 1), *row->errors.probe_mean, 1e-12) << curve.spec;
  }
  ASSERT_TRUE(one.observations.slice);
  const Slice& slice = *one.observations.slice;
  EXPECT_EQ(slice.spheres.size(), 3U) << "4 and 5 do not reach the plane";
  EXPECT_EQ(slice.cut, 3U);
  ASSERT_EQ(slice.frames.size(), 3U) << "the initial state and two output times";
  EXPECT_EQ(slice.frames[0].value, (std::vector<double>{0, 0, 10}));
  EXPECT_GT(slice.frames[2].value[1], slice.frames[1].value[1]) << "it warms up";
}

TEST(Observations, WithoutAReferenceTheFirstMethodThatWorksIsPictured) {
  const CaseFolder folder;
  const BenchCase one = bench(
      write_spheres(folder, "baseline = \"cvode\"\nintegrators = [\"forward-euler:step=50\", \"cvode\"]\n",
                    /*conductivity=*/0.1),
      "none");
  ASSERT_TRUE(one.observations.slice);
  EXPECT_EQ(one.observations.slice->source, "cvode");
  EXPECT_EQ(one.observations.slice->frames.size(), 3U);
  for (const auto& curve : one.observations.curves) EXPECT_TRUE(curve.reference.empty());
}

}  // namespace
}  // namespace superstep
