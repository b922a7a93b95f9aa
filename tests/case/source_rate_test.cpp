/// What sources can do at most, beside a current that does nothing.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "case/scene.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

/// Three spheres in a row; the first is cooled with 1 W. `electrodes` hold their potentials, or nothing.
FieldFacts thermal_facts(const std::string& law, const std::string& electrodes) {
  test::TemporaryFolder folder;
  folder.write("row.csv", "id,x,y,z,radius\n0,0,0,0,0.5\n1,0,0,0.95,0.5\n2,0,0,1.9,0.5\n");
  const Scene scene = load_scene(folder.write("case.toml", R"(t_end = 1.0
[packing]
file = "row.csv"
length_unit = "mm"
[material]
density = 5000.0
[contact]
neck = "coble"
[electric]
specific_capacity = 1e3
conductivity = )" + law + "\n" + electrodes + R"(
[thermal]
conductivity = 50.0
specific_heat = 500.0
initial = 300.0
source = [ { where = { ids = [0] }, value = -1.0 } ]
)"));
  return scene.rhs->facts().fields.back();
}

const std::string line = R"({ law = "linear", value = 1e5, coefficient = 0.001, reference = 300.0 })";
const double rate = 1.0 / (5000.0 * 500.0 * 4.0 / 3.0 * std::numbers::pi * std::pow(0.5e-3, 3));  // K/s

TEST(SourceRate, IsThatOfTheSourcesWhereNoPotentialsDiffer) {
  // A line has no largest value: what it may rise by is infinite, and so is no part of nothing.
  for (const auto& law : {std::string("1e5"), line}) {
    const FieldFacts facts = thermal_facts(law, "");
    EXPECT_NEAR(facts.source_rate, rate, 1e-9 * rate) << law;
    EXPECT_TRUE(facts.has_sources);
    EXPECT_NEAR(attainable_range({300, 300}, facts, 2).low, 300 - 2 * rate, 1e-9 * rate) << law;
  }
}

TEST(SourceRate, IsWithoutBoundWhereACurrentMayGrowWithTheLine) {
  const std::string electrodes =
      "fixed = [ { where = { ids = [2] }, value = 1.0 }, { where = { ids = [0] }, value = 0.0 } ]";
  EXPECT_TRUE(std::isinf(thermal_facts(line, electrodes).source_rate));
  const double bounded = thermal_facts("1e5", electrodes).source_rate;
  EXPECT_TRUE(std::isfinite(bounded) && bounded > rate);
}

}  // namespace
}  // namespace superstep
