#pragma once
/// Which of many entries are kept where a picture cannot show all.

#include <cstddef>
#include <vector>

namespace superstep {

/// Positions of at most `most` of n entries, evenly spread, the first and the last among them. most >= 2.
[[nodiscard]] std::vector<std::size_t> evenly_thinned(std::size_t n, std::size_t most);

/// Positions of at most `most` of n entries in ascending order, chosen at random so that no pattern of theirs
/// shows; the same ones every time.
[[nodiscard]] std::vector<std::size_t> randomly_thinned(std::size_t n, std::size_t most);

}  // namespace superstep
