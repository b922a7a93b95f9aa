#include "core/text/number.hpp"

#include <gtest/gtest.h>

namespace superstep {
namespace {

TEST(Number, TakesDecimalNumbersWhole) {
  EXPECT_EQ(parse_number("1.5e-3"), 1.5e-3);
  EXPECT_EQ(parse_number("+2"), 2.0);
  EXPECT_EQ(parse_number("-0.25"), -0.25);
  EXPECT_EQ(parse_integer("-7"), -7);
}

TEST(Number, RefusesEverythingElse) {
  for (const char* text :
       {"", " 1", "1 ", "1,5", "0x10", "1e999", "nan", "inf", "-inf", "1.0f", "--1", "+-1", "1e", "."})
    EXPECT_FALSE(parse_number(text)) << text;
  for (const char* text : {"", "1.0", "9223372036854775808", "0x1", "1e3"})
    EXPECT_FALSE(parse_integer(text)) << text;
}

}  // namespace
}  // namespace superstep
