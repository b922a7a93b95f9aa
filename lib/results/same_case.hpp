#pragma once
/// Whether two benchmarks measured the same case.

#include <string>

#include "results/results.hpp"

namespace superstep {

/// Throws InputError where two cases of one name differ in a size, a time or the unit of errors.
///   file, other_file  where they stand; empty = not named
void require_same_case(const BenchCase& one, const std::string& file, const BenchCase& other,
                       const std::string& other_file);

}  // namespace superstep
