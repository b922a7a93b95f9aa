#pragma once
/// Values of command-line options, parsed strictly; every failure is a UsageError that names option, value
/// and range.

#include <cstdint>
#include <string>

#include "bench/host/terminal.hpp"
#include "packing/generate.hpp"

namespace superstep {

/// Integer in [min, max].
[[nodiscard]] std::int64_t parse_integer_option(const std::string& option, const std::string& text,
                                                std::int64_t min, std::int64_t max);
/// Finite number > 0.
[[nodiscard]] double parse_positive_option(const std::string& option, const std::string& text);
[[nodiscard]] ColorMode parse_color_mode(const std::string& text);

/// "lognormal:median=..,sigma=..,min=..,max=.." | "uniform:min=..,max=.." | "list:d1,d2,..".
///   unit [m]  length of one unit of the diameters
[[nodiscard]] SizeDistribution parse_sizes(const std::string& text, double unit);

/// Metres per unit for the name of a length unit.
[[nodiscard]] double parse_length_unit(const std::string& text);

}  // namespace superstep
