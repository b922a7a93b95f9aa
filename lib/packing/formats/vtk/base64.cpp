#include "packing/formats/vtk/base64.hpp"

#include <array>
#include <cstdint>

namespace superstep {
namespace {

constexpr std::array<signed char, 256> digit_table() {
  std::array<signed char, 256> table{};
  table.fill(-1);
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t k = 0; k < digits.size(); ++k)
    table[static_cast<unsigned char>(digits[k])] = static_cast<signed char>(k);
  return table;
}
constexpr auto digit_of = digit_table();

}  // namespace

std::size_t append_base64(std::string_view text, std::size_t most, std::string& out) {
  std::uint32_t group = 0;
  int digits = 0, padding = 0;
  const std::size_t end = out.size() + most;
  std::size_t k = 0;
  for (; k < text.size() && out.size() < end; ++k) {
    const auto c = static_cast<unsigned char>(text[k]);
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    const int digit = c == '=' ? 0 : digit_of[c];
    if (digit < 0) break;
    padding += c == '=' ? 1 : 0;
    group = group << 6 | static_cast<std::uint32_t>(digit);
    if (++digits < 4) continue;
    for (int byte = 0; byte < 3 - padding && out.size() < end; ++byte)
      out.push_back(static_cast<char>(group >> (16 - 8 * byte) & 0xFF));
    group = 0;
    digits = padding = 0;
  }
  return k;
}

}  // namespace superstep
