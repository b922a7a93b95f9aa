#pragma once
/// Counts with their nouns: "1 step", "2 steps".

#include <fmt/format.h>

#include <concepts>
#include <string>
#include <string_view>

namespace superstep {

/// The count and its noun.
///   one   as in "step", or "fixed node"
///   many  where it is not `one` with an s, as in "rows sum" beside "row sums"
[[nodiscard]] std::string quantity(std::integral auto count, std::string_view one,
                                   std::string_view many = {}) {
  if (count != 1 && !many.empty()) return fmt::format("{} {}", count, many);
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

}  // namespace superstep
