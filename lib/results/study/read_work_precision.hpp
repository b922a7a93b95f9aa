#pragma once
/// work_precision.csv, read back.

#include <string>

#include "results/study/work_precision.hpp"

namespace superstep {

/// Everything but title and unit, which the file does not hold. Throws InputError.
[[nodiscard]] WorkPrecision read_work_precision_csv(const std::string& path);

}  // namespace superstep
