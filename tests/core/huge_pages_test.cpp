/// Memory of bases: what was given back is taken again, up to a limit, by whoever asks for the same size.

#include "core/huge_pages.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <thread>
#include <vector>

#include "core/memory.hpp"

namespace superstep {
namespace {

constexpr std::size_t per_page = huge_page / sizeof(double);

TEST(HugePages, BeginWithAPageAndAreTakenAgain) {
  double* first = nullptr;
  {
    const auto array = huge_page_array<double>(3 * per_page);
    first = array.get();
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(first) % huge_page, 0u);
    first[0] = first[3 * per_page - 1] = 1;
  }
  const auto smaller = huge_page_array<double>(2 * per_page);
  EXPECT_NE(smaller.get(), first) << "it is of another size";
  EXPECT_EQ(huge_page_array<double>(3 * per_page - 1).get(), first);
  EXPECT_EQ(huge_page_array<float>(6 * per_page).get(), reinterpret_cast<float*>(first));
}

TEST(HugePages, NoMoreThanTheLimitIsKept) {
  constexpr std::size_t each = 16;  // huge pages
  give_back_memory();
  EXPECT_EQ(kept_huge_pages(), 0u);
  std::vector<HugePageArray<double>> arrays;
  for (std::size_t k = 0; k < huge_pages_kept / (each * huge_page) + 3; ++k)
    arrays.push_back(huge_page_array<double>(each * per_page));
  EXPECT_EQ(kept_huge_pages(), 0u);
  arrays.clear();
  EXPECT_EQ(kept_huge_pages(), huge_pages_kept);
  const auto again = huge_page_array<double>(each * per_page);
  EXPECT_EQ(kept_huge_pages(), huge_pages_kept - each * huge_page);
}

/// Whoever measures the memory of a run must see all of it, whatever ran before.
TEST(HugePages, AreFreedBeforeMemoryIsMeasured) {
  { const auto array = huge_page_array<double>(per_page); }
  EXPECT_GT(kept_huge_pages(), 0u);
  give_back_memory();
  EXPECT_EQ(kept_huge_pages(), 0u);
}

TEST(HugePages, ThreadsShareThem) {
  std::vector<std::jthread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([t] {
      for (int k = 0; k < 200; ++k) {
        auto array = huge_page_array<double>(per_page);
        array[0] = t;
        std::this_thread::yield();
        EXPECT_EQ(array[0], t);
      }
    });
}

}  // namespace
}  // namespace superstep
