#pragma once
/// Which ids there are, for messages about one that is not among them.

#include <cstdint>
#include <span>
#include <string>

namespace superstep {

/// "ids run from 1 to 400", "ids are 3, 7, 12", "there are 500 ids from 3 to 900".
[[nodiscard]] std::string ids_in_words(std::span<const std::int64_t> ids);
/// The first of these, for all ids from one to the other.
[[nodiscard]] std::string ids_in_words(std::int64_t first, std::int64_t last);

}  // namespace superstep
