#pragma once
/// Plain values as bytes, to be sent from one process to another of the same program.

#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace superstep {

/// What may be copied byte by byte.
template <class Value>
concept Plain = std::is_trivially_copyable_v<Value>;

class Packer {
 public:
  template <Plain Value>
  void put(const Value& value) {
    append(&value, sizeof value);
  }
  template <Plain Value>
  void put_all(std::span<const Value> values) {
    put(values.size());
    append(values.data(), values.size_bytes());
  }
  template <Plain Value>
  void put(const std::vector<Value>& values) {
    put_all(std::span<const Value>(values));
  }
  void put(const std::string& text) { put_all(std::span<const char>(text)); }

  [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return bytes_; }

 private:
  void append(const void* data, std::size_t size) {
    const std::size_t before = bytes_.size();
    bytes_.resize(before + size);
    if (size > 0) std::memcpy(bytes_.data() + before, data, size);
  }
  std::vector<std::byte> bytes_;
};

/// Takes out what was put in, in the same order.
class Unpacker {
 public:
  explicit Unpacker(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <Plain Value>
  void take(Value& value) {
    copy(&value, sizeof value);
  }
  template <Plain Value>
  void take(std::vector<Value>& values) {
    values.resize(take<std::size_t>());
    copy(values.data(), values.size() * sizeof(Value));
  }
  void take(std::string& text) {
    text.resize(take<std::size_t>());
    copy(text.data(), text.size());
  }
  template <class Value>
  [[nodiscard]] Value take() {
    Value value{};
    take(value);
    return value;
  }

 private:
  void copy(void* data, std::size_t size) {
    if (size > 0) std::memcpy(data, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }
  std::span<const std::byte> rest_;
};

}  // namespace superstep
