#pragma once
/// Text that comes from users, made harmless for HTML.

#include <cstdint>
#include <string>
#include <string_view>

namespace superstep {

/// Text for element content and for attributes in double quotes: markup characters as entities, control
/// characters other than tab and line break dropped, bytes that are not UTF-8 replaced by U+FFFD.
[[nodiscard]] std::string html_text(std::string_view text);

/// A sentence for element content: words with a setting, as "rkc:rtol=1e-3,step=2", break after ':' and ','
/// alone.
[[nodiscard]] std::string sentence_html(std::string_view text);

/// Valid UTF-8: every byte that is not becomes U+FFFD.
[[nodiscard]] std::string valid_utf8(std::string_view text);

/// At most `most` characters; what is cut off is replaced by an ellipsis. Never splits a UTF-8 sequence.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most);

/// Number of characters of valid UTF-8.
[[nodiscard]] std::size_t characters(std::string_view text) noexcept;

/// "1.23e-04" as people write it: plain where it is short, else "1.23 x 10^-4" with a superscript.
///   digits  significant digits
[[nodiscard]] std::string number_text(double value, int digits = 3);

/// 10 to a power, with a superscript.
[[nodiscard]] std::string power_text(int power);

/// An integer with blanks between groups of three digits.
[[nodiscard]] std::string count_text(std::uint64_t value);

}  // namespace superstep
