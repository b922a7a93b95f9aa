#pragma once
/// "Did you mean": the candidate closest to a mistyped name.

#include <span>
#include <string>
#include <string_view>

namespace superstep {

/// Closest candidate by edit distance, whatever its capitals, that is near enough to be a slip of the pen;
/// else empty.
[[nodiscard]] std::string nearest_by_spelling(std::string_view name, std::span<const std::string> candidates);

/// The same; where none is near enough to be a slip of the pen, the closest of
/// those that hold the name or that it holds, as in "benchmark" for "bench"; else empty.
[[nodiscard]] std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// "; did you mean 'x'?", or nothing: for messages that list the candidates by themselves.
[[nodiscard]] std::string near_miss(std::string_view name, std::span<const std::string> candidates);

/// "; did you mean 'x'?" or, without a near candidate, "; valid are: a, b, c".
[[nodiscard]] std::string suggestion(std::string_view name, std::span<const std::string> candidates);

}  // namespace superstep
