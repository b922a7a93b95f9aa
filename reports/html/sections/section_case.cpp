/// What was computed: facts, health of the network, a picture of the packing.

#include <fmt/format.h>

#include <algorithm>

#include "core/text/number.hpp"
#include "core/text/options.hpp"
#include "reports/chart/chart_packing.hpp"
#include "reports/html/html_parts.hpp"
#include "reports/html/sections/sections.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

using Json = nlohmann::ordered_json;
using Facts = std::vector<std::pair<std::string, std::string>>;

Number number_in(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? Number(found->get<double>()) : std::nullopt;
}

void add(Facts& facts, const std::string& name, const Number& value, const std::string& unit = "",
         int digits = 4) {
  if (value) facts.emplace_back(name, number_text(*value, digits) + (unit.empty() ? "" : " " + unit));
}

/// Of a file that somebody may have written by hand: what no count can be is shown as it is.
std::string count_of(const Number& value) {
  const double number = value.value_or(0);
  return number >= 0 && number < 0x1p63 ? count_text(static_cast<std::uint64_t>(number))
                                        : number_text(number);
}

void add_packing(Facts& facts, const Json& packing) {
  if (const auto low = number_in(packing, "diameter_min"), high = number_in(packing, "diameter_max");
      low && high)
    facts.emplace_back("diameters",
                       fmt::format("{} to {} µm", number_text(*low * 1e6), number_text(*high * 1e6)));
  add(facts, "relative density", number_in(packing, "relative_density"));
  if (const auto overlap = packing.find("overlap"); overlap != packing.end()) {
    const auto median = number_in(*overlap, "median"), most = number_in(*overlap, "max");
    if (median && most)
      facts.emplace_back("overlap / smaller radius",
                         fmt::format("median {}, largest {}", number_text(*median), number_text(*most)));
  }
}

void add_field(Facts& facts, const Json& field) {
  const std::string name = field.value("field", "field");
  const auto free = number_in(field, "free"), fixed = number_in(field, "fixed"),
             idle = number_in(field, "idle"), eliminated = number_in(field, "eliminated");
  if (free && fixed)
    facts.emplace_back(
        name + ": nodes",
        fmt::format(
            "{} free, {} fixed, {} idle{}", count_of(free), count_of(fixed), count_of(idle),
            eliminated && *eliminated > 0 ? fmt::format(", {} of capacity 0", count_of(eliminated)) : ""));
  if (const auto floating = number_in(field, "floating_clusters"), all = number_in(field, "components"); all)
    facts.emplace_back(name + ": clusters", fmt::format("{:.0f}, of these {:.0f} without a fixed node", *all,
                                                        floating.value_or(0)));
  if (const auto degree = field.find("coordination"); degree != field.end())
    add(facts, name + ": mean coordination", number_in(*degree, "mean"));
  add(facts, name + ": effective conductivity", number_in(field, "effective_conductivity"),
      name == "temperature" ? "W/(m K)" : "S/m");
  add(facts, name + ": fastest rate λ max", number_in(field, "lambda_max"), "1/s");
  add(facts, name + ": slowest rate λ min", number_in(field, "lambda_min"), "1/s");
  const auto largest = number_in(field, "lambda_max"), smallest = number_in(field, "lambda_min");
  if (largest && smallest && *smallest > 0)
    add(facts, name + ": stiffness", Number(*largest / *smallest), "", 3);
  add(facts, name + ": critical step of forward Euler", number_in(field, "critical_step"), "s");
  add(facts, name + ": certified step", number_in(field, "certified_step"), "s");
  add(facts, name + ": lumping ratio K/(π κ R), median", number_in(field, "lumping_median"), "", 3);
}

Facts facts_of(const CaseInput& input) {
  const BenchCase& one = input.bench;
  Facts facts;
  if (!one.source.empty()) facts.emplace_back("source", one.source);
  facts.emplace_back("nodes", count_text(one.nodes));
  facts.emplace_back("contacts", count_text(one.contacts));
  facts.emplace_back("unknowns", count_text(one.unknowns));
  facts.emplace_back("simulated time", number_text(one.t_end) + " s");
  std::string times;
  for (const double t : one.output_times) times += (times.empty() ? "" : ", ") + number_text(t);
  if (!times.empty()) facts.emplace_back("output times [s]", times);
  facts.emplace_back("baseline", one.baseline);
  facts.emplace_back("reference", one.reference ? one.reference->spec : "none: errors were not measured");
  if (!input.health) return facts;
  if (const auto packing = input.health->find("packing"); packing != input.health->end())
    add_packing(facts, *packing);
  if (const auto fields = input.health->find("fields"); fields != input.health->end())
    for (const auto& field : *fields) add_field(facts, field);
  return facts;
}

std::string list_of(const std::vector<std::string>& lines) {
  if (lines.empty()) return {};
  std::string out = "<ul>\n";
  for (const auto& line : lines) out += fmt::format("<li>{}</li>\n", html_text(line));
  return out + "</ul>\n";
}

}  // namespace

std::vector<CaseField> fields_of(const BenchCase& one) {
  for (const auto& row : one.rows)
    if (row.potential) return {{"temperature", "K", false}, {"potential", "V", true}};
  return {{one.unit == "V" ? "potential" : "temperature", one.unit, false}};
}

Number parameter(const BenchRow& row, const std::string& key) {
  try {
    for (const auto& [name, value] : parse_spec(row.spec).settings)
      if (name == key) return parse_number(value);
  } catch (const std::exception&) {  // not a SPEC: it has no parameters
  }
  return std::nullopt;
}

TimeUnit time_unit(double t_end) {
  if (t_end >= 1) return {};
  if (t_end >= 1e-3) return {1e3, "ms"};
  if (t_end >= 1e-6) return {1e6, "µs"};
  return {1e9, "ns"};
}

std::string case_section(const CaseInput& input, const std::string& id) {
  std::string body = fact_list(facts_of(input));
  if (const auto& slice = input.bench.observations.slice) body += packing_figures(*slice, id + "-packing");
  return html_section(id + "-case", "The case", "", body);
}

std::string skipped_section(const CaseInput& input, const std::string& id) {
  std::vector<std::string> skips;
  for (const auto& skip : input.bench.skips) skips.push_back(skip.what + " because " + skip.because);
  std::string body = list_of(skips);
  if (!input.bench.warnings.empty()) body += "<h4>Warnings</h4>\n" + list_of(input.bench.warnings);
  return html_section(
      id + "-skipped", "What was skipped, and warnings",
      skips.empty() ? "Nothing was skipped." : "Work that this scene does not need was not done.", body);
}

}  // namespace superstep
