#pragma once
/// Arrays that begin with a cache line, so that a vector register never straddles two.

#include <cstddef>
#include <memory>
#include <new>

namespace superstep {

constexpr std::size_t cache_line = 64;  ///< bytes

struct AlignedDelete {
  void operator()(void* memory) const noexcept { ::operator delete (memory, std::align_val_t{cache_line}); }
};

template <class Number>
using AlignedArray = std::unique_ptr<Number[], AlignedDelete>;

/// Not initialised: whoever writes a part first decides where in the machine its memory lies.
template <class Number>
[[nodiscard]] AlignedArray<Number> aligned_array(std::size_t size) {
  return AlignedArray<Number>(
      static_cast<Number*>(::operator new (size * sizeof(Number), std::align_val_t{cache_line})));
}

}  // namespace superstep
