#include "core/text/ids_in_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace superstep {

std::string ids_in_words(std::int64_t first, std::int64_t last) {
  return first == last ? fmt::format("the only id is {}", first)
                       : fmt::format("ids run from {} to {}", first, last);
}

std::string ids_in_words(std::span<const std::int64_t> ids) {
  constexpr std::size_t few = 8;
  if (ids.empty()) return "there are none";
  const auto [low, high] = std::minmax_element(ids.begin(), ids.end());
  // Unsigned, since the range of all integers has more members than an integer can count.
  const auto beyond_low = static_cast<std::uint64_t>(*high) - static_cast<std::uint64_t>(*low);
  if (beyond_low == ids.size() - 1) return ids_in_words(*low, *high);
  if (ids.size() <= few)
    return fmt::format("ids are {}", fmt::join(std::set<std::int64_t>(ids.begin(), ids.end()), ", "));
  return fmt::format("there are {} ids from {} to {}", ids.size(), *low, *high);
}

}  // namespace superstep
