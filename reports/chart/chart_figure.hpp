#pragma once
/// The frame around every picture of the report.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace superstep {

/// <figure> with title, caption, picture and, when not empty, its numbers for scripts.
///   kind  class of the figure: "xy", "bars", "grid", "packing"
///   data  {"columns": [...], "rows": [[...]]} for a CSV download; charts add what zooming needs
[[nodiscard]] std::string figure(const std::string& kind, const std::string& id, const std::string& title,
                                 const std::string& caption, const std::string& picture,
                                 const nlohmann::ordered_json& data);

/// A number with so many significant digits; null for what is not finite.
[[nodiscard]] nlohmann::ordered_json number_json(double value, int digits);

/// JSON that may stand inside a <script> element: ASCII, and without '<'.
[[nodiscard]] std::string script_json(const nlohmann::ordered_json& json);

}  // namespace superstep
