#include "core/text/suggest.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace superstep {
namespace {

const std::vector<std::string> commands = {"run", "bench", "info", "stability", "pack", "list", "report"};

TEST(NearestName, FindsSlipsOfThePen) {
  EXPECT_EQ(nearest_name("bnech", commands), "bench") << "two letters swapped";
  EXPECT_EQ(nearest_name("benhc", commands), "bench");
  EXPECT_EQ(nearest_name("urn", commands), "run");
  EXPECT_EQ(nearest_name("benc", commands), "bench") << "one missing";
  EXPECT_EQ(nearest_name("bencch", commands), "bench") << "one too many";
  EXPECT_EQ(nearest_name("reprot", commands), "report");
}

TEST(NearestName, FindsTheNameInALongerOrAShorterOne) {
  EXPECT_EQ(nearest_name("benchmark", commands), "bench");
  EXPECT_EQ(nearest_name("info-of-a-case", commands), "info");
  const std::vector<std::string> methods = {"forward-euler", "exponential", "cvode"};
  EXPECT_EQ(nearest_name("euler", methods), "forward-euler");
  EXPECT_EQ(nearest_name("ode", methods), "") << "a few letters are in anything";
  const std::vector<std::string> laws = {"hertzian-of-old", "hertzian-x"};
  EXPECT_EQ(nearest_name("hertz", laws), "hertzian-x") << "the closest of several";
}

TEST(NearestName, CapitalsAreNoDifference) {
  const std::vector<std::string> methods = {"rkc", "rkl", "bdf"};
  EXPECT_EQ(nearest_name("RKC", methods), "rkc");
  EXPECT_EQ(nearest_name("I", std::vector<std::string>{"j", "i"}), "i");
}

TEST(NearestName, DoesNotGuessWildly) {
  const std::vector<std::string> columns = {"i", "j", "conductance"};
  EXPECT_EQ(nearest_name("g", columns), "") << "any letter is one letter away from any other";
  EXPECT_EQ(nearest_name("xyz", commands), "");
  EXPECT_EQ(nearest_name("hcneb", commands), "");
  EXPECT_EQ(nearest_name(std::string(1000, 'b'), commands), "");
  EXPECT_EQ(nearest_name("", commands), "");
}

}  // namespace
}  // namespace superstep
