#pragma once
/// Vectors over all entries of a state, laid out for threads.

#include <vector>

#include "core/aligned_array.hpp"
#include "core/parallel.hpp"

namespace superstep {

/// Allocates whole cache lines, each page first written by the thread that `for_ranges` gives its entries to:
/// on machines with several memories the page then lies near that thread.
template <class Number>
struct FirstTouchAllocator {
  using value_type = Number;

  FirstTouchAllocator() = default;
  template <class Other>
  explicit FirstTouchAllocator(const FirstTouchAllocator<Other>& /*other*/) noexcept {}

  [[nodiscard]] Number* allocate(std::size_t size) {
    auto memory = aligned_array<Number>(size);
    constexpr std::size_t page = 4096 / sizeof(Number);
    for_ranges(size, size, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; i += page) memory[i] = Number{};
    });
    return memory.release();
  }
  void deallocate(Number* memory, std::size_t /*size*/) noexcept { AlignedDelete{}(memory); }
  bool operator==(const FirstTouchAllocator&) const = default;
};

using StateVector = std::vector<double, FirstTouchAllocator<double>>;

}  // namespace superstep
