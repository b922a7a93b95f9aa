#include "reports/html/sections/paper_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text/options.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

bool same(const Number& a, double b) {
  return a && std::abs(*a - b) <= 1e-9 * std::abs(b);
}

bool evaluates_heat_every_substep(const BenchRow& row) {
  const auto settings = parse_spec(row.spec).settings;
  return std::any_of(settings.begin(), settings.end(), [](const auto& setting) {
    return setting.first == "heat" && setting.second == "substep";
  });
}

}  // namespace

const BenchRow* our_run(const BenchCase& one, const PublishedRun& published, bool heat_every_substep) {
  for (const auto& row : one.rows) {
    if (published.nu == 0 && row.spec == one.baseline) return heat_every_substep ? nullptr : &row;
    if (row.integrator == "sts" && same(parameter(row, "n"), published.n) &&
        same(parameter(row, "nu"), published.nu) && evaluates_heat_every_substep(row) == heat_every_substep)
      return &row;
  }
  return nullptr;
}

HtmlTable::Cell published_name(const PublishedRun& run) {
  if (run.nu == 0) return {.text = "forward Euler"};
  return {.text = fmt::format("ν = {}, N = {:.0f}", number_text(run.nu), run.n),
          .sort_key = fmt::format("{}", -run.nu * 1e6 + run.n)};
}

HtmlTable::Cell ratio_cell(const Number& ours, const Number& published) {
  if (!ours || !published || *published == 0) return {};
  return number_cell(Number(*ours / *published));
}

}  // namespace superstep
