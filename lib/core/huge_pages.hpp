#pragma once
/// Memory in huge pages, where the system has them: touching a new small page can cost as much as computing
/// what goes onto it. What is given back is kept for the next who asks, since a system that hands out fresh
/// pages has to clear them first.

#include <cstddef>
#include <memory>

namespace superstep {

constexpr std::size_t huge_page = std::size_t{2} << 20;  ///< bytes, of x86-64 and others

/// What is kept of what was given back, of all together [bytes].
constexpr std::size_t huge_pages_kept = std::size_t{256} << 20;

/// Memory that begins with a huge page. Not initialised; worth it from some huge pages on. Throws
/// std::bad_alloc.
///   bytes  a multiple of huge_page
[[nodiscard]] void* take_huge_pages(std::size_t bytes);
/// Back from `take_huge_pages`, with the same size.
void give_huge_pages_back(void* memory, std::size_t bytes) noexcept;
/// What is kept now [bytes]; `give_back_memory` frees it.
[[nodiscard]] std::size_t kept_huge_pages() noexcept;

struct HugePageDelete {
  std::size_t bytes = 0;
  void operator()(void* memory) const noexcept { give_huge_pages_back(memory, bytes); }
};

template <class Number>
using HugePageArray = std::unique_ptr<Number[], HugePageDelete>;

/// Not initialised.
template <class Number>
[[nodiscard]] HugePageArray<Number> huge_page_array(std::size_t size) {
  const std::size_t bytes = (size * sizeof(Number) + huge_page - 1) / huge_page * huge_page;
  return {static_cast<Number*>(take_huge_pages(bytes)), HugePageDelete{bytes}};
}

}  // namespace superstep
