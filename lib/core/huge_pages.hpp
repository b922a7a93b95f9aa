#pragma once
/// Memory in huge pages, where the system has them: touching a new small page can cost as much as computing
/// what goes onto it.

#include <sys/mman.h>

#include <cstddef>
#include <memory>
#include <new>

namespace superstep {

constexpr std::size_t huge_page = std::size_t{2} << 20;  ///< bytes, of x86-64 and others

struct HugePageDelete {
  void operator()(void* memory) const noexcept { ::operator delete (memory, std::align_val_t{huge_page}); }
};

template <class Number>
using HugePageArray = std::unique_ptr<Number[], HugePageDelete>;

/// Not initialised. Worth it from some huge pages on.
template <class Number>
[[nodiscard]] HugePageArray<Number> huge_page_array(std::size_t size) {
  const std::size_t bytes = (size * sizeof(Number) + huge_page - 1) / huge_page * huge_page;
  HugePageArray<Number> array(static_cast<Number*>(::operator new (bytes, std::align_val_t{huge_page})));
#ifdef MADV_HUGEPAGE
  (void)::madvise(array.get(), bytes, MADV_HUGEPAGE);  // advice: without it all is the same, but slower
#endif
  return array;
}

}  // namespace superstep
