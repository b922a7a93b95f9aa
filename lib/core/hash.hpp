#pragma once
/// The one hash of the project: 128 bits that name contents.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace superstep {

/// XXH3 with 128 bits over everything added, in order. Source: Collet, github.com/Cyan4973/xxHash.
class ContentHash {
 public:
  ContentHash();
  /// Length first, so that neighbouring pieces cannot run into each other.
  ContentHash& add(std::string_view text);
  ContentHash& add_number(double value);
  template <class Value>
  ContentHash& add_all(std::span<const Value> values) {
    static_assert(std::is_arithmetic_v<Value> || std::is_enum_v<Value>, "padding has no defined content");
    return add({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
  }
  /// 32 hexadecimal digits.
  [[nodiscard]] std::string text() const;

 private:
  struct State;
  struct Free {
    void operator()(State* state) const noexcept;
  };
  std::unique_ptr<State, Free> state_;
};

}  // namespace superstep
