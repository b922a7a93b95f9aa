#pragma once
/// Files that appear whole or not at all.

#include <functional>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace superstep {

/// Writes `content` to a temporary beside the file, flushes it to disk and renames it over `path`; then the
/// folder is flushed, too. Creates missing parent folders. Throws OutputError and leaves nothing
/// half-written.
///
/// A symbolic link stays and its target is written. A file that is there keeps its permissions; a new one has
/// those that the umask leaves. Devices, pipes and sockets are refused but for /dev/stdout, /dev/stderr and
/// /dev/null, which are written to.
///
/// A process that was killed leaves its temporary: the next one that writes into the folder removes it.
void write_file_atomically(const std::string& path, std::string_view content);

/// The same of a content that comes in pieces: pieces(write) calls write(piece) for one after the other. What
/// it throws leaves nothing behind.
using PieceWriter = std::function<void(std::string_view)>;
void write_file_atomically(const std::string& path, const std::function<void(const PieceWriter&)>& pieces);

/// The same of a file that others fill, too: fill(temporary) has all of it written into a file that is there
/// and empty, named from the root. Neither flushing nor renaming is its business; what it throws leaves
/// nothing behind. False, and nothing is written, where it returns false, and where `path` is a link, a
/// stream or a device: take the way above then.
[[nodiscard]] bool fill_file_atomically(const std::string& path,
                                        const std::function<bool(const std::string& temporary)>& fill);

/// What the functions above throw, for those who fill.
[[nodiscard]] OutputError write_error(const std::string& path, const std::string& why);

}  // namespace superstep
