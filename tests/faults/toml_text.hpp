#pragma once
/// Case files written from a tree, with one thing about them wrong.

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace superstep::test {

using Tree = nlohmann::ordered_json;

/// What stands in the place of one key and its value.
struct Edit {
  std::string place;  ///< with indices: `thermal.fixed[0].value`
  std::string key;    ///< written instead of its name
  std::string value;  ///< TOML, written instead of its value
  std::string more;   ///< "key = value" written after it; empty = nothing
};

struct TomlText {
  std::string text;
  std::map<std::string, int> line;  ///< of the key at each place
  int line_of_more = 0;             ///< of what stands after an edit
};

/// Tables with headers, as a person writes them; what stands inside arrays in one line each.
[[nodiscard]] TomlText toml_text(const Tree& root, const std::optional<Edit>& edit = std::nullopt);

/// One value in one line.
[[nodiscard]] std::string toml_value(const Tree& value);

}  // namespace superstep::test
