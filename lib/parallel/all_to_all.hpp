#pragma once
/// Every process has something for every other one.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "parallel/communicator.hpp"
#include "parallel/packed.hpp"

namespace superstep {

/// Collective: `own[k]` goes to process k; what comes back stands in the order of those that it came from.
[[nodiscard]] std::vector<std::vector<std::byte>> all_to_all(std::vector<std::vector<std::byte>> own,
                                                             Communicator& among);

/// The same of plain values: all that came, in the order of ranks. What was handed out is given back as it
/// goes.
template <Plain Value>
[[nodiscard]] std::vector<Value> all_to_all(std::vector<std::vector<Value>> own, Communicator& among) {
  std::vector<std::vector<std::byte>> bytes;
  for (auto& values : own) {
    const auto view = std::as_bytes(std::span(values));
    bytes.emplace_back(view.begin(), view.end());
    std::vector<Value>().swap(values);
  }
  bytes = all_to_all(std::move(bytes), among);
  std::size_t size = 0;
  for (const auto& part : bytes) size += part.size() / sizeof(Value);
  std::vector<Value> all(size);
  std::size_t begin = 0;
  for (auto& part : bytes) {
    if (!part.empty()) std::memcpy(all.data() + begin, part.data(), part.size());
    begin += part.size() / sizeof(Value);
    std::vector<std::byte>().swap(part);
  }
  return all;
}

/// Collective: everybody's values one behind the other, everywhere.
[[nodiscard]] std::vector<double> everywhere(std::span<const double> own, Communicator& among);

/// Consecutive nodes or layers.
struct IndexRange {
  std::int64_t begin = 0, end = 0;
  [[nodiscard]] bool empty() const noexcept { return begin >= end; }
  [[nodiscard]] std::size_t size() const noexcept {
    return empty() ? 0 : static_cast<std::size_t>(end - begin);
  }
  [[nodiscard]] bool holds(std::int64_t k) const noexcept { return k >= begin && k < end; }
  [[nodiscard]] IndexRange overlap(const IndexRange& other) const noexcept {
    return {std::max(begin, other.begin), std::min(end, other.end)};
  }
};
/// Which of ranges one behind the other holds k.
[[nodiscard]] std::size_t range_that_holds(std::span<const IndexRange> ranges, std::int64_t k) noexcept;
/// Collective: that of each process, everywhere.
[[nodiscard]] std::vector<IndexRange> everywhere(IndexRange own, Communicator& among);

}  // namespace superstep
