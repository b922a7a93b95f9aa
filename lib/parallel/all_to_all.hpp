#pragma once
/// Every process has something for every other one.

#include <cstddef>
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

}  // namespace superstep
