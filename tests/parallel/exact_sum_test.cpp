/// Sums without rounding: the same in any order and any groups, and right.

#include "parallel/exact_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "parallel/reduction.hpp"

namespace superstep {
namespace {

double exact(const std::vector<double>& terms) {
  ExactSum sum;
  for (const double term : terms) sum.add(term);
  return sum.value();
}

/// Any finite double, all exponents alike.
double any_number(std::mt19937_64& random) {
  while (true) {
    const auto x = std::bit_cast<double>(random());
    if (std::isfinite(x)) return x;
  }
}

TEST(ExactSums, OfOneTermAreThatTerm) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 20'000; ++k) {
    const double x = any_number(random);
    ASSERT_EQ(exact({x}), x);
  }
  const double smallest = std::numeric_limits<double>::denorm_min(),
               largest = std::numeric_limits<double>::max();
  for (const double x : {0.0, smallest, -smallest, largest, -largest, 1.0}) EXPECT_EQ(exact({x}), x);
}

TEST(ExactSums, OfTwoTermsAreRoundedOnceAsTheProcessorDoes) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 50'000; ++k) {
    // Exponents close to each other, so that both have a part in the sum.
    const double a = std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())),
                                static_cast<int>(random() % 90) - 1100);
    const double b = std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())),
                                static_cast<int>(random() % 90) - 1100);
    ASSERT_EQ(exact({a, b}), a + b);
  }
}

TEST(ExactSums, LoseNothingThatLaterTermsBringToLight) {
  EXPECT_EQ(exact({1e300, 1.0, -1e300}), 1.0);
  EXPECT_EQ(exact({1.0, 1e100, 1.0, -1e100}), 2.0);
  EXPECT_EQ(exact({0.1, 0.2, -0.3}), 0x1p-55);  // what the roundings of the three make: 2.8e-17
  const double half_unit = 0x1p-53;
  EXPECT_EQ(exact({1.0, half_unit}), 1.0);  // a tie goes to the even one
  EXPECT_EQ(exact({1.0, half_unit, 0x1p-1074}), 1.0 + 0x1p-52);
  EXPECT_EQ(exact({1.0 + 0x1p-52, half_unit}), 1.0 + 0x1p-51);
}

TEST(ExactSums, DoNotDependOnOrderOrGroups) {
  std::mt19937_64 random(3);
  std::vector<double> terms;
  for (int k = 0; k < 3000; ++k) terms.push_back(any_number(random));
  const double expected = exact(terms);
  for (int trial = 0; trial < 20; ++trial) {
    std::shuffle(terms.begin(), terms.end(), random);
    ExactSum all;
    for (std::size_t k = 0; k < terms.size();) {  // in groups that travel as words
      ExactSum group;
      for (const std::size_t end = std::min(terms.size(), k + random() % 400 + 1); k < end; ++k)
        group.add(terms[k]);
      all.add(ExactSum::of(group.words()));
    }
    ASSERT_EQ(all.value(), expected);
  }
}

TEST(ExactSums, KnowWhatIsNoNumber) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(exact({1, infinity}), infinity);
  EXPECT_EQ(exact({-infinity, 1}), -infinity);
  EXPECT_TRUE(std::isnan(exact({infinity, -infinity})));
  EXPECT_TRUE(std::isnan(exact({std::nan(""), 1})));
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(exact({largest, largest}), infinity);
  EXPECT_EQ(exact({largest, largest, -largest}), largest);
}

TEST(ExactSums, OfWordsAreThoseOfTerms) {
  // As a launcher's processes add them up: word by word.
  std::mt19937_64 random(4);
  ExactSum all;
  ExactSum::Words words{};
  for (int process = 0; process < 7; ++process) {
    ExactSum own;
    for (int k = 0; k < 100; ++k) {
      const double x = any_number(random) * 1e-3;
      own.add(x);
      all.add(x);
    }
    const auto part = own.words();
    for (std::size_t k = 0; k < words.size(); ++k) words[k] += part[k];
  }
  EXPECT_EQ(ExactSum::of(words).value(), all.value());
}

TEST(Partitions, CoverAllRowsByWholeBlocks) {
  for (const std::int64_t rows : {0, 1, 63, 64, 65, 1000, 4096})
    for (const int processes : {1, 2, 3, 4, 7, 100}) {
      std::int64_t next = 0;
      for (int rank = 0; rank < processes; ++rank) {
        const Partition partition(rows, processes, rank, 64);
        EXPECT_EQ(partition.begin(), next);
        EXPECT_TRUE(partition.begin() % 64 == 0 || partition.begin() == rows);
        for (std::int64_t row = partition.begin(); row < partition.end(); ++row)
          EXPECT_EQ(partition.owner(row), rank);
        next = partition.end();
      }
      EXPECT_EQ(next, rows);
    }
}

/// The sums that processes with some of the blocks each would put together are those of one that has all.
TEST(Reductions, AreTheSameWhoeverHasTheBlocks) {
  std::mt19937_64 random(5);
  std::vector<double> terms;
  for (int k = 0; k < 100'000; ++k)
    terms.push_back(std::ldexp(static_cast<double>(random() >> 11), -static_cast<int>(random() % 80)));
  const double whole = Reduction(terms.size()).sum([&](std::size_t i) { return terms[i]; });
  for (const int processes : {2, 3, 4, 7}) {
    ExactSum all;
    for (int rank = 0; rank < processes; ++rank) {
      const Partition own(static_cast<std::int64_t>(terms.size()), processes, rank, block_rows());
      const auto first = static_cast<std::size_t>(own.begin());
      RowSum rows;
      for (std::size_t i = 0; i < own.owned(); ++i) rows.add(i, terms[first + i]);
      ExactSum chunks;  // as a process's reduction does it
      for (std::size_t begin = 0; begin < own.owned(); begin += chunk_rows()) {
        const std::size_t size = std::min(chunk_rows(), own.owned() - begin);
        chunks.add(Reduction(size).sum([&](std::size_t i) { return terms[first + begin + i]; }));
      }
      all.add(chunks);
    }
    EXPECT_EQ(all.value(), whole);
  }
}

}  // namespace
}  // namespace superstep
