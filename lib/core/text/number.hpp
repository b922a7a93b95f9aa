#pragma once
/// One strict number parser for files, case files and the command line.

#include <cstdint>
#include <optional>
#include <string_view>

namespace superstep {

/// Decimal floating-point number: the whole token, finite, no hexadecimal, no locale. A leading '+' is
/// allowed.
[[nodiscard]] std::optional<double> parse_number(std::string_view token) noexcept;

/// Decimal integer: the whole token, in range of int64. A leading '+' is allowed.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view token) noexcept;

/// The same where programs write whole numbers with a fraction or an exponent, as in 12.0 or 1.2e1.
[[nodiscard]] std::optional<std::int64_t> parse_whole_number(std::string_view token) noexcept;

}  // namespace superstep
