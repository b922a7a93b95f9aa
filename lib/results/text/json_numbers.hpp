#pragma once
/// Numbers that may be none, in JSON.

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace superstep {

/// JSON has no infinity: a step that nothing limits is null.
[[nodiscard]] inline nlohmann::json finite_or_null(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

[[nodiscard]] inline nlohmann::json optional_number(const std::optional<double>& value) {
  return value ? finite_or_null(*value) : nlohmann::json(nullptr);
}

[[nodiscard]] inline nlohmann::json positive_or_null(double value) {
  return value > 0 ? nlohmann::json(value) : nlohmann::json(nullptr);
}

}  // namespace superstep
