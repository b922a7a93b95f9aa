#pragma once
/// Scenes that all processes build together, each its own part.

#include <stdexcept>
#include <string>

#include "case/scene.hpp"
#include "core/text/toml.hpp"
#include "parallel/communicator.hpp"

namespace superstep {

/// A scene that one process has to read for all, as they have found out while they built it. The text says
/// why.
struct NeedsOneReader : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Whether processes can share a case like that: see can_be_layered, can_be_shared_network. `why_not` is set
/// where the case asks for it and cannot have it. Throws InputError for what is wrong anyway.
[[nodiscard]] bool can_be_in_parts(const TomlTable& root, std::string& why_not);

/// Collective: every process reads the same case. The scene's right-hand side and its initial state are those
/// of the rows that are here, its graph holds the probed nodes alone. Throws InputError and NeedsOneReader,
/// on all processes the same.
[[nodiscard]] Scene build_in_parts(TomlTable root, Communicator& among);

}  // namespace superstep
