#include "results/same_case.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace superstep {

std::string difference_of(const BenchCase& one, const BenchCase& other) {
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
  return found;
}

}  // namespace superstep
