#pragma once
/// What a case says, as one hash: the name of everything that is computed from it and kept.

#include <string>

#include "core/text/toml.hpp"

namespace superstep {

/// Hash of every value of a case and of every byte of the files that it names, whatever they are for.
/// Comments, blanks, the order of keys, `title`, `source`, `[bench]` and `[published]` change no answer and
/// do not count. Throws InputError for a file that cannot be read.
[[nodiscard]] std::string content_hash(const TomlTable& root);

}  // namespace superstep
