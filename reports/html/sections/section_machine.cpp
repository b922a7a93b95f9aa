/// Where and with what the numbers were made.

#include <fmt/format.h>

#include <algorithm>

#include "reports/html/html_parts.hpp"
#include "reports/html/sections/sections.hpp"

namespace superstep {
namespace {

using Facts = std::vector<std::pair<std::string, std::string>>;

void add(Facts& out, const std::vector<Fact>& facts) {
  for (const auto& fact : facts) {
    std::string name = fact.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    out.emplace_back(name, fact.value);
  }
}

}  // namespace

std::string machine_section(const ReportInput& input) {
  Facts facts;
  if (input.bench) {
    facts.emplace_back(
        "superstep",
        input.bench->version + (input.bench->revision.empty() ? "" : " (" + input.bench->revision + ")"));
    facts.emplace_back("repetitions", fmt::format("{}", input.bench->repetitions));
    facts.emplace_back("threads", fmt::format("{}", input.bench->threads));
    add(facts, input.bench->machine);
    add(facts, input.bench->libraries);
  } else if (!input.runs.empty()) {
    const RunRecord& run = input.runs.front().record;
    facts.emplace_back("superstep", run.version + (run.revision.empty() ? "" : " (" + run.revision + ")"));
    facts.emplace_back("threads", fmt::format("{}", run.threads));
    add(facts, run.machine);
    add(facts, run.libraries);
  }
  return html_section("machine", "Machine and versions", "", fact_list(facts));
}

}  // namespace superstep
