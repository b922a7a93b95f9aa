#pragma once
/// Files that appear whole or not at all.

#include <string>
#include <string_view>

namespace superstep {

/// Writes `content` to a temporary beside `path`, flushes it to disk and renames it over `path`.
/// Creates missing parent folders. Throws OutputError and leaves nothing half-written.
void write_file_atomically(const std::string& path, std::string_view content);

}  // namespace superstep
