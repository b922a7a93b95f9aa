#pragma once
/// Content hashes that name cached results.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "case/scene.hpp"

namespace superstep {

/// 128-bit FNV-1a. Source: Fowler, Noll & Vo, www.isthe.com/chongo/tech/comp/fnv
class Digest {
 public:
  Digest& add_bytes(const void* data, std::size_t size) noexcept;
  /// Length first, so that neighbouring pieces cannot run into each other.
  Digest& add(std::string_view text) noexcept;
  template <class Value>
  Digest& add_all(std::span<const Value> values) noexcept {
    static_assert(std::is_arithmetic_v<Value> || std::is_enum_v<Value>, "padding has no defined content");
    add_number(static_cast<double>(values.size()));
    return add_bytes(values.data(), values.size_bytes());
  }
  Digest& add_number(double value) noexcept { return add_bytes(&value, sizeof value); }
  /// 32 hexadecimal digits.
  [[nodiscard]] std::string text() const;

 private:
  __extension__ using Word = unsigned __int128;
  Word hash_ = (static_cast<Word>(0x6c62272e07bb0142U) << 64U) | 0x62b821756295c58dU;
};

/// Everything in a scene that a solution depends on: networks, roles, initial and fixed values, sources,
/// output times and probes, and where the values stand in the state. Terms that live in the right-hand side
/// alone are caught by the values that it returns for two states. Names, titles and what `[bench]` asks for
/// do not count.
void add_scene(Digest& digest, const Scene& scene);

}  // namespace superstep
