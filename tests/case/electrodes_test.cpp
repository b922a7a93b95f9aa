/// What electrodes do where nodes between them have no capacity.

#include <gtest/gtest.h>

#include "case/checks/effective.hpp"
#include "case/scene.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

/// 1 V over 2 S and 2 S in series, with a node of capacity 0 between them and a free one at its side.
///   source [A]  fed into the node of capacity 0
Scene load(const test::CaseFolder& folder, const std::string& source) {
  folder.write("nodes.csv",
               "id,capacity,source,initial,fixed\n1,1,0,0,1\n2,0," + source + ",0,\n3,1,0,0,0\n4,1,0,0,\n");
  folder.write("edges.csv", "i,j,conductance\n1,2,2\n2,3,2\n2,4,1\n");
  return load_scene(
      folder.write("case.toml",
                   "t_end = 1.0\n[network]\nnodes = \"nodes.csv\"\nedges = \"edges.csv\"\nfield = "
                   "\"potential\"\n"));
}

std::optional<ElectrodeFacts> facts_of(const Scene& scene) {
  return electrode_facts(scene.fields[0], field_at_start(scene, scene.fields[0]));
}

TEST(Electrodes, CurrentThroughANodeOfCapacityZeroCounts) {
  const test::CaseFolder folder;
  const auto facts = facts_of(load(folder, "0"));
  ASSERT_TRUE(facts);
  EXPECT_NEAR(facts->current_in, 1, 1e-12);
  EXPECT_NEAR(facts->current_out, 1, 1e-12);
  EXPECT_NEAR(facts->resistance.value_or(0), 1, 1e-12);
  EXPECT_NEAR(facts->joule_heat, 1, 1e-12);
}

/// Half of what is fed into that node leaves at either electrode, past the network that is integrated.
TEST(Electrodes, AreLeftOutWhereANodeOfCapacityZeroIsFed) {
  const test::CaseFolder folder;
  EXPECT_TRUE(facts_of(load(folder, "0")));
  EXPECT_FALSE(facts_of(load(folder, "3")));
}

}  // namespace
}  // namespace superstep
