#pragma once
/// Numbers of nodes and places in lists are stored short and signed; vectors are indexed by std::size_t.

#include <cstddef>
#include <cstdint>

namespace superstep {

/// A stored number >= 0 as an index.
[[nodiscard]] constexpr std::size_t at(std::int32_t number) noexcept {
  return static_cast<std::size_t>(number);
}
[[nodiscard]] constexpr std::size_t at(std::int64_t number) noexcept {
  return static_cast<std::size_t>(number);
}

}  // namespace superstep
