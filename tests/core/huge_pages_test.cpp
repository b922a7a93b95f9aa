/// Memory of bases: what was given back is taken again, up to a limit, by whoever asks for the same size.

#include "core/huge_pages.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <thread>
#include <vector>

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
  constexpr std::size_t kept = huge_pages_kept / (each * huge_page);
  std::vector<HugePageArray<double>> arrays;
  for (std::size_t k = 0; k < kept + 3; ++k) arrays.push_back(huge_page_array<double>(each * per_page));
  std::set<double*> known;
  for (const auto& array : arrays) known.insert(array.get());
  EXPECT_EQ(known.size(), kept + 3) << "each is its own";
  arrays.clear();
  // Memory that the system hands out anew may lie anywhere; what is kept comes back.
  for (std::size_t k = 0; k < kept; ++k) {
    arrays.push_back(huge_page_array<double>(each * per_page));
    known.erase(arrays.back().get());
  }
  EXPECT_LE(known.size(), 3 + 3u) << "some of them may have been kept before this test";
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
