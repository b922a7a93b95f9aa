#include "results/same_case.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace superstep {

void require_same_case(const BenchCase& one, const std::string& file, const BenchCase& other,
                       const std::string& other_file) {
  std::string found;
  const auto compare = [&](const std::string& fact, const auto& a, const auto& b) {
    if (found.empty() && a != b) found = fmt::format("{} = {}, and {}", fact, a, b);
  };
  compare("nodes", one.nodes, other.nodes);
  compare("contacts", one.contacts, other.contacts);
  compare("unknowns", one.unknowns, other.unknowns);
  compare("t_end", one.t_end, other.t_end);
  compare("number of output_times", one.output_times.size(), other.output_times.size());
  for (std::size_t k = 0; k < std::min(one.output_times.size(), other.output_times.size()); ++k)
    compare(fmt::format("output_times[{}]", k), one.output_times[k], other.output_times[k]);
  compare("error_unit", one.unit, other.unit);
  if (!found.empty())
    throw InputError(fmt::format(
        "{}case '{}' has {} {}: they are two cases of one name; measure one of them again, or rename it",
        file.empty() ? "" : file + ": ", one.name, found,
        other_file.empty() ? "before" : "in " + other_file));
}

}  // namespace superstep
