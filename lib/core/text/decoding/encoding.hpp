#pragma once
/// Text in the encodings that editors and spreadsheets leave, as UTF-8 with lines that end in LF.

#include <string>

namespace superstep {

/// Rewrites UTF-16 of either byte order (with its mark, or characters of Latin-1 two bytes wide) as UTF-8,
/// drops a UTF-8 byte order mark, and turns the lone CR at the end of old Macintosh lines into LF. Other
/// bytes stay.
[[nodiscard]] std::string to_utf8(std::string bytes);

}  // namespace superstep
