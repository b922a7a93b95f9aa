/// Counts agree with their nouns.

#include "core/text/quantity.hpp"

#include <gtest/gtest.h>

namespace superstep {
namespace {

TEST(Quantity, OneIsSingularAndAllOthersArePlural) {
  EXPECT_EQ(quantity(0, "step"), "0 steps");
  EXPECT_EQ(quantity(1, "step"), "1 step");
  EXPECT_EQ(quantity(2u, "fixed node"), "2 fixed nodes");
  EXPECT_EQ(quantity(1, "row sums", "rows sum"), "1 row sums");
  EXPECT_EQ(quantity(3, "row sums", "rows sum"), "3 rows sum");
}

}  // namespace
}  // namespace superstep
