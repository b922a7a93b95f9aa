#pragma once
/// Base64, as VTK writes binary data into XML: several encoded pieces may follow each other, each with its
/// padding.

#include <cstddef>
#include <string>
#include <string_view>

namespace superstep {

/// Appends what `text` stands for to `out`, blanks skipped, until it ends, a foreign character comes, or
/// `out` has grown by `most` bytes. Returns how many characters were used.
std::size_t append_base64(std::string_view text, std::size_t most, std::string& out);

}  // namespace superstep
