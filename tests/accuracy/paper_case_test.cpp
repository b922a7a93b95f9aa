/// The case that holds the published runs.

#include <gtest/gtest.h>

#include <algorithm>

#include "case/scene.hpp"
#include "reports/html/published.hpp"
#include "reports/html/sections/paper_parts.hpp"

namespace superstep {
namespace {

const std::string cases = std::string(SUPERSTEP_SOURCE_DIR) + "/cases/";

/// What a benchmark of a case would hold, without any measurement.
BenchCase unmeasured(const Scene& scene) {
  BenchCase one;
  one.baseline = scene.bench.baseline;
  for (const auto& spec : scene.bench.integrators) {
    BenchRow& row = one.rows.emplace_back();
    row.spec = spec;
    row.integrator = spec.substr(0, spec.find(':'));
  }
  if (std::find(scene.bench.integrators.begin(), scene.bench.integrators.end(), one.baseline) ==
      scene.bench.integrators.end())
    one.rows.emplace_back().spec = one.baseline;
  return one;
}

TEST(PaperCase, HoldsEveryPublishedRun) {
  for (const char* name : {"nial_thermal_paper.toml", "nial_thermoelectric.toml"}) {
    const Scene scene = load_scene(cases + name);
    const auto published = published_case(scene.source);
    ASSERT_TRUE(published) << name;
    const BenchCase one = unmeasured(scene);
    for (const auto& run : published->runs)
      EXPECT_NE(our_run(one, run), nullptr) << name << ": n = " << run.n << ", nu = " << run.nu;
    EXPECT_EQ(published->runs.size(), name == std::string("nial_thermal_paper.toml") ? 16U : 13U);
    EXPECT_LE(published->measure.to, scene.t_end) << "the window of the published errors is covered";
  }
}

TEST(PaperCase, IsTheSceneOfNialThermal) {
  const Scene paper = load_scene(cases + "nial_thermal_paper.toml"),
              plain = load_scene(cases + "nial_thermal.toml");
  EXPECT_EQ(paper.source, plain.source);
  EXPECT_EQ(paper.output_times, plain.output_times);
  EXPECT_EQ(paper.initial, plain.initial);
  EXPECT_EQ(paper.published, plain.published);
  ASSERT_EQ(paper.rhs->size(), plain.rhs->size());
  std::vector<double> a(paper.rhs->size()), b(a.size()), y(a.size());
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = static_cast<double>(i % 97);
  (*paper.rhs)(0, y, a);
  (*plain.rhs)(0, y, b);
  EXPECT_EQ(a, b) << "the same conductances, capacities and fixed values";
}

}  // namespace
}  // namespace superstep
