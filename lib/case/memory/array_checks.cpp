#include "case/memory/array_checks.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"

namespace superstep {

void require_length(const std::string& name, const std::string& array, std::size_t found,
                    std::size_t expected, const std::string& rule) {
  if (found == expected) return;
  throw InputError(
      fmt::format("{}: {} has {} values, and must have {}: {}", name, array, found, expected, rule));
}

void require_finite(const std::string& name, const std::string& array, std::span<const double> values) {
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!std::isfinite(values[k]))
      throw InputError(fmt::format("{}: value {} of {} is {}; it must be finite", name, k, array, values[k]));
}

}  // namespace superstep
