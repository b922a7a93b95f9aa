#include "core/text/number.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace superstep {
namespace {

std::string_view without_plus(std::string_view token) noexcept {
  const bool signed_twice = token.size() > 1 && (token[1] == '-' || token[1] == '+');
  return !token.empty() && token.front() == '+' && !signed_twice ? token.substr(1) : token;
}

template <class Number>
std::optional<Number> parse_whole(std::string_view token) noexcept {
  token = without_plus(token);
  Number value{};
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc{} || end != token.data() + token.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parse_number(std::string_view token) noexcept {
  const auto value = parse_whole<double>(token);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> parse_integer(std::string_view token) noexcept {
  return parse_whole<std::int64_t>(token);
}

std::optional<std::int64_t> parse_whole_number(std::string_view token) noexcept {
  if (const auto integer = parse_integer(token)) return integer;
  constexpr double largest = 9007199254740992.0;  // 2^53: up to here doubles hold every integer
  const auto number = parse_number(token);
  if (!number || std::abs(*number) > largest || *number != std::nearbyint(*number)) return std::nullopt;
  return static_cast<std::int64_t>(*number);
}

}  // namespace superstep
