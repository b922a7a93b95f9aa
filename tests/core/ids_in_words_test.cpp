#include "core/text/ids_in_words.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace superstep {
namespace {

using Ids = std::vector<std::int64_t>;

TEST(IdsInWords, ARangeAFewOrHowMany) {
  EXPECT_EQ(ids_in_words(Ids{3, 1, 2}), "ids run from 1 to 3");
  EXPECT_EQ(ids_in_words(Ids{7}), "the only id is 7");
  EXPECT_EQ(ids_in_words(Ids{12, 3, 7}), "ids are 3, 7, 12");
  EXPECT_EQ(ids_in_words(Ids{9, 2, 3, 4, 5, 6, 7, 8, 20}), "there are 9 ids from 2 to 20");
  EXPECT_EQ(ids_in_words(Ids{}), "there are none");
  constexpr auto low = std::numeric_limits<std::int64_t>::min(),
                 high = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(ids_in_words(Ids{low, high}), "ids are -9223372036854775808, 9223372036854775807");
}

}  // namespace
}  // namespace superstep
