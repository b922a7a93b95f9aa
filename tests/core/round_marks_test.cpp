#include "core/round_marks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace superstep {
namespace {

TEST(RoundMarks, AreMultiplesOfAStepBetweenTheEnds) {
  EXPECT_EQ(round_marks(-3.9, 6, round_step(9.9)), (std::vector<double>{-2, 0, 2, 4, 6}));
  EXPECT_FALSE(std::signbit(round_marks(-0.3, 1, 1).front())) << "minus zero is written as -0";
  EXPECT_EQ(round_marks(0, 0.3 * (1 - 1e-15), 0.1).size(), 4U) << "an end that a rounding has cut";
}

TEST(RoundMarks, EndWhereTheEndsDifferByOneRounding) {
  // One more step to such a number is the same number: adding steps up never got to the end.
  for (const double low : {400.0, 1e-250, -7e200, 0.9}) {
    const double high = std::nextafter(low, 1e300);
    EXPECT_LT(round_marks(low, high, round_step(high - low)).size(), 20U) << low;
    const auto room = room_for_marks(low, high);
    EXPECT_LT(room.low, low);
    EXPECT_GT(room.high, high);
    const auto marks = round_marks(room.low, room.high, round_step(room.high - room.low));
    ASSERT_GE(marks.size(), 2U) << low;
    EXPECT_LT(marks.size(), 20U) << low;
    for (std::size_t k = 1; k < marks.size(); ++k) EXPECT_LT(marks[k - 1], marks[k]) << low;
  }
}

}  // namespace
}  // namespace superstep
