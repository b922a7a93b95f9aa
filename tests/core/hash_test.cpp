#include "core/hash.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace superstep {
namespace {

TEST(ContentHash, MatchesThePublishedVectorOfNoInput) {
  EXPECT_EQ(ContentHash().text(), "99aa06d3014798d86001c324468d497f");
}

TEST(ContentHash, NeighbouringPiecesCannotRunIntoEachOther) {
  EXPECT_NE(ContentHash().add("ab").add("c").text(), ContentHash().add("a").add("bc").text());
  EXPECT_NE(ContentHash().add("").text(), ContentHash().text());
}

TEST(ContentHash, TellsNumbersApartThatPrintAlike) {
  EXPECT_NE(ContentHash().add_number(1).text(), ContentHash().add_number(1 + 1e-15).text());
  const std::vector<double> some = {1, 2}, others = {2, 1};
  EXPECT_NE(ContentHash().add_all<double>(some).text(), ContentHash().add_all<double>(others).text());
}

}  // namespace
}  // namespace superstep
