#pragma once
/// Every process has something for every other one.

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "parallel/communicator.hpp"
#include "parallel/packed.hpp"

namespace superstep {

/// Collective: `own[k]` goes to process k; what comes back stands in the order of those that it came from.
[[nodiscard]] std::vector<std::vector<std::byte>> all_to_all(std::vector<std::vector<std::byte>> own,
                                                             Communicator& among);

/// The same of plain values: all that came, in the order of ranks.
template <Plain Value>
[[nodiscard]] std::vector<Value> all_to_all(std::span<const std::vector<Value>> own, Communicator& among) {
  std::vector<std::vector<std::byte>> bytes;
  for (const auto& values : own) {
    const auto view = std::as_bytes(std::span(values));
    bytes.emplace_back(view.begin(), view.end());
  }
  std::vector<Value> all;
  for (const auto& part : all_to_all(std::move(bytes), among)) {
    const std::size_t before = all.size();
    all.resize(before + part.size() / sizeof(Value));
    if (!part.empty()) std::memcpy(all.data() + before, part.data(), part.size());
  }
  return all;
}

/// Collective: everybody's values one behind the other, everywhere.
[[nodiscard]] std::vector<double> everywhere(std::span<const double> own, Communicator& among);

}  // namespace superstep
