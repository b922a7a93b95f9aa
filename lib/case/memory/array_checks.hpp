#pragma once
/// What is asked of every array that a caller hands over.

#include <span>
#include <string>

namespace superstep {

/// Throws InputError "name: array has 5 values, ..." unless there are as many as there must be.
///   rule  what they are, as in "one for each node"
void require_length(const std::string& name, const std::string& array, std::size_t found,
                    std::size_t expected, const std::string& rule);

/// Throws InputError for the first value that is not finite.
void require_finite(const std::string& name, const std::string& array, std::span<const double> values);

}  // namespace superstep
