#pragma once
/// Room for many vectors of one length, taken in blocks as they are asked for.

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/huge_pages.hpp"

namespace superstep {

/// Entries are left untouched, so that the thread that will read them is the first to write them.
template <class T>
class VectorStore {
 public:
  explicit VectorStore(std::size_t length = 0) : length_(length), stride_((length + line - 1) / line * line) {
    const std::size_t bytes = std::max<std::size_t>(1, stride_ * sizeof(T));
    per_block_ = std::clamp<std::size_t>(largest_block / bytes, 1, most_per_block);
  }
  /// Vector number k [length]; those before stay where they are.
  [[nodiscard]] std::span<T> at(std::size_t k) {
    while (k >= blocks_.size() * per_block_) blocks_.push_back(huge_page_array<T>(stride_ * per_block_));
    return {blocks_[k / per_block_].get() + k % per_block_ * stride_, length_};
  }
  /// The same of a vector that was asked for before.
  [[nodiscard]] const T* operator[](std::size_t k) const noexcept {
    return blocks_[k / per_block_].get() + k % per_block_ * stride_;
  }

 private:
  static constexpr std::size_t line = 64 / sizeof(T);           // entries of a cache line
  static constexpr std::size_t largest_block = 16 * huge_page;  // bytes
  static constexpr std::size_t most_per_block = 256;            // vectors
  std::size_t length_, stride_, per_block_ = 1;
  std::vector<HugePageArray<T>> blocks_;
};

}  // namespace superstep
