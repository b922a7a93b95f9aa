#pragma once
/// A case, whatever it is about: what a case file says, read once and handed on.

#include <string>
#include <variant>

#include "case/press/press.hpp"
#include "case/scene.hpp"

namespace superstep {

/// A network that stays as it is, or particles that move.
using Case = std::variant<Scene, Press>;

/// Parses a case file. Throws InputError for anything that is not TOML, and says so where it is a packing,
/// which a case names.
[[nodiscard]] TomlTable parse_case(const std::string& path);

/// Reads a case file and everything that it names: a press where there is a table [dynamics], else a scene.
/// Throws InputError with file, line, value, rule and way out.
[[nodiscard]] Case load_case(const std::string& path);
/// The same of a file that is parsed already; `root` then knows which keys were asked for.
///   placed  told which part of a press's particles is placed, where that takes time
[[nodiscard]] Case load_case(TomlTable root, const dynamics::Placed& placed = {});

[[nodiscard]] const CaseHead& head_of(const Case& one);

}  // namespace superstep
