#pragma once
/// `conductivity = 85.0` or a law of temperature.

#include "core/text/toml.hpp"
#include "rhs/conductivity_law.hpp"

namespace superstep {

/// Reads a positive number, or a table with `law`:
///   { law = "linear", value, coefficient [1/K], reference [K] }
///   { law = "table", temperatures = [...], values = [...] }
///   { law = "sigmoid", value, amplitude [-], steepness [1/K], reference [K] }
/// each with `outside` = "error" (default) or "clamp".
/// Throws InputError.
[[nodiscard]] ConductivityLaw read_conductivity(const TomlValue& conductivity);

}  // namespace superstep
