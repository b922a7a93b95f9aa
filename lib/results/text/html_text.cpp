#include "results/text/html_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace superstep {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

bool continues(char c) noexcept {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Length of the UTF-8 sequence at the beginning of `text`; 0 when it is not one (overlong ones, surrogates
/// and numbers beyond U+10FFFF are none).
std::size_t sequence_length(std::string_view text) noexcept {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if (!continues(text[k])) return 0;
  const unsigned second = byte(1);
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F)) return 0;
  if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F)) return 0;
  return length;
}

}  // namespace

std::string valid_utf8(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    out.append(length == 0 ? replacement : text.substr(0, length));
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

std::string html_text(std::string_view text) {
  std::string out;
  for (const char c : valid_utf8(text)) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\'')
      out += "&#39;";
    else if (static_cast<unsigned char>(c) >= 0x20 || c == '\t' || c == '\n')
      out += c == '\x7F' ? ' ' : c;
  }
  return out;
}

std::string sentence_html(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, std::min(text.find(' '), text.size()));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (!out.empty()) out += ' ';
    if (word.find('=') == std::string_view::npos) {
      out += html_text(word);
      continue;
    }
    for (std::size_t begin = 0; begin < word.size();) {
      const std::size_t end = std::min(word.find_first_of(":,", begin), word.size() - 1) + 1;
      out += fmt::format("{}<span class=\"whole\">{}</span>", begin > 0 ? "<wbr>" : "",
                         html_text(word.substr(begin, end - begin)));
      begin = end;
    }
  }
  return out;
}

std::size_t characters(std::string_view text) noexcept {
  std::size_t count = 0;
  for (const char c : text) count += continues(c) ? 0 : 1;
  return count;
}

std::string shortened(std::string_view text, std::size_t most) {
  const std::string valid = valid_utf8(text);
  if (characters(valid) <= most) return valid;
  std::size_t kept = 0, end = 0;
  for (; end < valid.size(); ++end) {
    if (continues(valid[end])) continue;
    if (kept + 1 == most) break;
    ++kept;
  }
  return valid.substr(0, end) + "…";
}

std::string power_text(int power) {
  constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = "10";
  for (const char c : fmt::format("{}", power)) out += c == '-' ? "⁻" : digits[c - '0'];
  return out;
}

std::string number_text(double value, int digits) {
  if (!std::isfinite(value)) return value > 0 ? "∞" : value < 0 ? "−∞" : "not a number";
  const double size = std::abs(value);
  if (value == 0) return "0";
  if (size >= 1e-3 && size < 1e5)
    return size >= std::pow(10.0, digits) ? fmt::format("{:.0f}", value)
                                          : fmt::format("{:.{}g}", value, digits);
  const std::string scientific = fmt::format("{:.{}e}", value, digits - 1);
  const auto e = scientific.find('e');
  std::string mantissa = scientific.substr(0, e);
  if (mantissa.find('.') != std::string::npos) {
    mantissa.erase(mantissa.find_last_not_of('0') + 1);
    if (mantissa.ends_with('.')) mantissa.pop_back();
  }
  const std::string power = power_text(std::stoi(scientific.substr(e + 1)));
  if (mantissa == "1") return power;
  return mantissa + "·" + power;
}

std::string count_text(std::uint64_t value) {
  const std::string digits = fmt::format("{}", value);
  if (digits.size() <= 4) return digits;
  std::string out;
  for (std::size_t k = 0; k < digits.size(); ++k) {
    if (k > 0 && (digits.size() - k) % 3 == 0) out += "\u202F";  // narrow, and no line breaks there
    out += digits[k];
  }
  return out;
}

}  // namespace superstep
