#pragma once
/// Networks of which nobody has the whole: each process reads its parts of the tables of nodes and edges, and
/// they hand each other what they own.
///
/// Rows are the free nodes in the order of the file, and blocks are consecutive cuts of it; neighbours can be
/// anywhere. The rows of a process come out as they would be cut from the whole network.

#include <string>

#include "case/scene.hpp"
#include "core/text/toml.hpp"
#include "parallel/communicator.hpp"

namespace superstep {

/// Whether processes can share a case like that: its network is a table of nodes and one of edges, whose rows
/// stay in the order of the file, and nothing beside them. `why_not` is set where the case wants that order
/// and cannot have its network shared. Throws InputError for what is wrong anyway.
[[nodiscard]] bool can_be_shared_network(const TomlTable& root, std::string& why_not);

/// See build_in_parts.
[[nodiscard]] Scene build_shared_network(TomlTable root, Communicator& among);

}  // namespace superstep
