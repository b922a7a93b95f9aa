#pragma once
/// Compressed bytes, by zlib: files that were gzipped, and the blocks inside VTK files.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace superstep {

/// True for the beginning of a gzip file.
[[nodiscard]] bool is_gzip(std::string_view bytes) noexcept;

/// What a gzip file holds, all of its members. Throws InputError (beginning with `path`) for a file that is
/// cut off or damaged, that goes on behind its last member with anything but noughts, or that unpacks to more
/// than `most` bytes.
[[nodiscard]] std::string gunzip(std::string_view bytes, const std::string& path, std::uintmax_t most);

/// Appends one zlib stream that holds exactly `size` bytes. Throws InputError (beginning with `where`).
void append_inflated(std::string_view bytes, std::size_t size, const std::string& where, std::string& out);

}  // namespace superstep
