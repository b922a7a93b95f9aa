#include "core/text/decoding/encoding.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace superstep {
namespace {

enum class Order { none, little, big };

bool is_plain(char c) noexcept {
  const auto byte = static_cast<unsigned char>(c);
  return (byte >= 0x20 && byte < 0x7F) || byte >= 0xA0 || byte == '\t' || byte == '\r' || byte == '\n';
}

/// UTF-16 by its mark; without one, when the beginning is Latin-1 with every other byte zero.
Order utf16_order(std::string_view bytes) noexcept {
  if (bytes.starts_with("\xFF\xFE")) return Order::little;
  if (bytes.starts_with("\xFE\xFF")) return Order::big;
  constexpr std::size_t looked_at = 64;
  const std::size_t size = std::min(looked_at, bytes.size()) / 2 * 2;
  if (size < 8) return Order::none;
  bool little = true, big = true;
  for (std::size_t k = 0; k < size; k += 2) {
    little = little && is_plain(bytes[k]) && bytes[k + 1] == '\0';
    big = big && bytes[k] == '\0' && is_plain(bytes[k + 1]);
  }
  return little ? Order::little : big ? Order::big : Order::none;
}

void append_code_point(std::string& out, std::uint32_t code) {
  const auto put = [&out](std::uint32_t byte) { out.push_back(static_cast<char>(byte)); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | code >> 6);
    put(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    put(0xE0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  } else {
    put(0xF0 | code >> 18);
    put(0x80 | (code >> 12 & 0x3F));
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  }
}

std::string from_utf16(std::string_view bytes, Order order) {
  constexpr std::uint32_t mark = 0xFEFF, replacement = 0xFFFD;
  const auto unit = [&](std::size_t k) {
    const auto first = static_cast<unsigned char>(bytes[k]),
               second = static_cast<unsigned char>(bytes[k + 1]);
    return order == Order::little ? static_cast<std::uint32_t>(second << 8 | first)
                                  : static_cast<std::uint32_t>(first << 8 | second);
  };
  std::string out;
  out.reserve(bytes.size() / 2);
  for (std::size_t k = 0; k + 1 < bytes.size(); k += 2) {
    std::uint32_t code = unit(k);
    const bool high = code >= 0xD800 && code < 0xDC00;
    if (high && k + 3 < bytes.size() && unit(k + 2) >= 0xDC00 && unit(k + 2) < 0xE000) {
      code = 0x10000 + ((code - 0xD800) << 10) + (unit(k + 2) - 0xDC00);
      k += 2;
    } else if (code >= 0xD800 && code < 0xE000) {
      code = replacement;  // half of a pair
    }
    if (code != mark || k > 0) append_code_point(out, code);
  }
  return out;
}

}  // namespace

std::string to_utf8(std::string bytes) {
  if (const Order order = utf16_order(bytes); order != Order::none) bytes = from_utf16(bytes, order);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  const bool is_text = bytes.find('\0') == std::string::npos;
  if (is_text && bytes.find('\n') == std::string::npos) std::replace(bytes.begin(), bytes.end(), '\r', '\n');
  return bytes;
}

}  // namespace superstep
