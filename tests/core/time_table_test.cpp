/// Tables of time with steps: values on both sides of them, integrals and ranges.

#include "core/time_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace superstep {
namespace {

// Numbers that binary fractions hold exactly, so that every comparison below can be exact.
//   4          +---
//             /
//   2        /|
//   1 --+      |
//   0   +------+ (0 to the left of t = 3, 2 from it on)
//       1      3  4
const TimeTable stairs{{1, 1, 3, 3, 4}, {1, 0, 0, 2, 4}};

TEST(TimeTable, IsLinearBetweenInstantsAndConstantBeyondThem) {
  const TimeTable ramp{{1, 3}, {2, 6}};
  EXPECT_EQ(ramp.at(-5), 2);
  EXPECT_EQ(ramp.at(1), 2);
  EXPECT_EQ(ramp.at(1.5), 3);
  EXPECT_EQ(ramp.at(3), 6);
  EXPECT_EQ(ramp.at(9), 6);
  for (const double t : {-5.0, 1.0, 1.5, 2.75, 3.0, 9.0}) EXPECT_EQ(ramp.before(t), ramp.at(t)) << t;
}

TEST(TimeTable, AStepHasTheRightValueAtItsInstantAndTheLeftOneBefore) {
  EXPECT_EQ(stairs.before(1), 1);
  EXPECT_EQ(stairs.at(1), 0);
  EXPECT_EQ(stairs.before(3), 0);
  EXPECT_EQ(stairs.at(3), 2);
  EXPECT_EQ(stairs.at(std::nextafter(3.0, 0.0)), 0);
  EXPECT_EQ(stairs.at(3.5), 3);
  EXPECT_EQ(stairs.before(3.5), 3);
}

TEST(TimeTable, StepsAtTheEndsSeparateTheValuesBeyond) {
  const TimeTable steps{{0, 0, 2, 2}, {5, 1, 1, 7}};
  EXPECT_EQ(steps.at(-1), 5);
  EXPECT_EQ(steps.before(0), 5);
  EXPECT_EQ(steps.at(0), 1);
  EXPECT_EQ(steps.before(2), 1);
  EXPECT_EQ(steps.at(2), 7);
  EXPECT_EQ(steps.at(3), 7);
  EXPECT_EQ(steps.before(3), 7);
}

TEST(TimeTable, IntegralIsTheAreaBetweenKnotsOneSidedAtSteps) {
  EXPECT_EQ(stairs.integral(0, 1), 1);       // the value before the step
  EXPECT_EQ(stairs.integral(1, 3), 0);       // neither step belongs to it
  EXPECT_EQ(stairs.integral(3, 4), 3);       // trapezoid from 2 to 4
  EXPECT_EQ(stairs.integral(3.5, 4), 1.75);  // from 3 to 4
  EXPECT_EQ(stairs.integral(4, 10), 24);     // the last value holds
  EXPECT_EQ(stairs.integral(-1, 6), 2 + 0 + 3 + 8);
  EXPECT_EQ(stairs.integral(6, -1), -13);
  EXPECT_EQ(stairs.integral(2, 2), 0);
  EXPECT_EQ(stairs.integral(3, 3), 0);
}

TEST(TimeTable, IntegralsOfPartsAddUp) {
  TimeTable saw;
  for (int k = 0; k < 1000; ++k) {
    saw.time.insert(saw.time.end(), {0.1 * k, 0.1 * k + 0.05});
    saw.value.insert(saw.value.end(), {std::sin(k), std::cos(3 * k)});
  }
  double parts = 0, from = -1;
  for (const double to : {-0.5, 0.0, 0.3, 17.123, 17.124, 50.0, 99.96, 120.0}) {
    parts += saw.integral(from, to);
    from = to;
  }
  // 2000 terms of size 0.05 at most, each rounded once or twice.
  EXPECT_NEAR(saw.integral(-1, 120), parts, 2000 * 0.05 * 4e-16);
}

TEST(TimeTable, RangeTakesWhatARunSees) {
  using Range = std::pair<double, double>;
  EXPECT_EQ(stairs.range(0, 10), Range(0, 4));
  EXPECT_EQ(stairs.range(1, 2), Range(0, 0));  // the value before the step is not seen any more
  EXPECT_EQ(stairs.range(0, 1), Range(0, 1));  // a step at the end shows both its values
  EXPECT_EQ(stairs.range(2, 3), Range(0, 2));
  EXPECT_EQ(stairs.range(3.25, 3.5), Range(2.5, 3));
  EXPECT_EQ(stairs.range(5, 6), Range(4, 4));
}

}  // namespace
}  // namespace superstep
