#pragma once
/// Checked values of case tables.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/text/toml.hpp"
#include "core/vec3.hpp"

namespace superstep::dynamics {

/// Number >= `least`, or `fallback` when the key is missing.
[[nodiscard]] double number_from(TomlTable& table, const std::string& key, double least, double fallback,
                                 const std::string& unit);
/// Required number >= `least`.
[[nodiscard]] double required_from(TomlTable& table, const std::string& key, double least,
                                   const std::string& unit);
/// Required number > 0, or `fallback`.
[[nodiscard]] double positive_or(TomlTable& table, const std::string& key, double fallback,
                                 const std::string& unit);
[[nodiscard]] bool boolean_or(TomlTable& table, const std::string& key, bool fallback);
/// Three numbers.
[[nodiscard]] Vec3 point_from(const TomlValue& value);
/// One of the words; `fallback` when the key is missing.
[[nodiscard]] std::string word_from(TomlTable& table, const std::string& key,
                                    const std::vector<std::string>& words, const std::string& fallback);
/// Required table.
[[nodiscard]] TomlTable table_from(TomlTable& table, const std::string& key, const std::string& why);

}  // namespace superstep::dynamics
