#pragma once
/// SPECs derived from other SPECs.

#include <optional>
#include <string>

namespace superstep {

/// `spec` with one key set to a value, added or replaced.
[[nodiscard]] std::string with_setting(const std::string& spec, const std::string& key,
                                       const std::string& value);

/// `spec` with another relative tolerance. Throws UsageError when the method has none, or when `rtol` is out
/// of range.
[[nodiscard]] std::string with_tolerance(const std::string& spec, double rtol);

/// The same SPEC at a relative tolerance 10 times looser; empty when it has none to loosen.
[[nodiscard]] std::optional<std::string> loosened(const std::string& spec);

/// A SPEC as a folder name: letters, digits and "-._=" stay, runs of anything else become one '_'.
[[nodiscard]] std::string folder_name(const std::string& spec);

}  // namespace superstep
