/// Published values beside ours (tables 1 to 4 of Rojek & Nisar 2026).

#include <fmt/format.h>

#include <algorithm>

#include "reports/html/sections/paper_parts.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

using Json = nlohmann::ordered_json;

/// Figures of the sample that the case file quotes from the paper, with ours.
std::string sample_table(const std::optional<Json>& health) {
  if (!health || !health->contains("published")) return {};
  HtmlTable table({{"figure of the sample", "", false}, {"published"}, {"ours"}, {"ours / published"}},
                  false);
  for (const auto& [key, value] : health->at("published").items()) {
    if (!value.is_object() || !value.contains("published") || !value.at("published").is_number()) continue;
    std::string name = key;
    std::replace(name.begin(), name.end(), '_', ' ');
    const Number theirs = value.at("published").get<double>();
    const Number ours = value.contains("ours") && value.at("ours").is_number()
                            ? Number(value.at("ours").get<double>())
                            : std::nullopt;
    table.add_row({{.text = name}, number_cell(theirs, 5), number_cell(ours, 5), ratio_cell(ours, theirs)});
  }
  return table.empty() ? "" : "<h4>The sample</h4>\n" + table.html();
}

/// A figure of the sample, `which` = "published" or "ours".
Number sample_figure(const std::optional<Json>& health, const char* key, const char* which) {
  if (!health || !health->contains("published") || !health->at("published").contains(key))
    return std::nullopt;
  const auto& value = health->at("published").at(key);
  if (!value.is_object() || !value.contains(which) || !value.at(which).is_number()) return std::nullopt;
  return value.at(which).get<double>();
}

/// Ratio of ours to a published figure of the sample.
Number sample_ratio(const std::optional<Json>& health, const char* key) {
  const Number ours = sample_figure(health, key, "ours"), published = sample_figure(health, key, "published");
  if (!ours || !published || *published == 0) return std::nullopt;
  return *ours / *published;
}

std::string differences(const CaseInput& input) {
  std::vector<std::string> reasons = {
      "The sample is not the paper's: that one is not public, ours was generated to its published number of "
      "particles, size range and density; its conductivity and spectrum came out close."};
  if (const auto ratio = sample_ratio(input.health, "pair_step"))
    reasons.push_back(
        fmt::format("Substeps: the step rule is alpha times the smallest pairwise step, which is {} times "
                    "the published one in our "
                    "sample, so that about 1/{} = {} of the published number of steps is needed.",
                    number_text(*ratio), number_text(*ratio), number_text(1 / *ratio)));
  reasons.push_back(
      "CPU times differ with machine and code; speedups, being ratios on one machine, can be compared.");
  reasons.push_back(fmt::format(
      "Errors: the paper subtracts its own forward Euler run from what super-time-stepping writes, which "
      "both "
      "do at step ends of their own. Our true errors are against a reference{} whose error bar is known, so "
      "that the error of forward Euler itself shows too.",
      input.bench.reference ? " (" + input.bench.reference->spec + ")" : ""));
  reasons.push_back(
      "Instants: the paper does not state when it writes nor where its transient ends. The rule that we use "
      "was chosen because its means come out closest; where supersteps end within an interval between two "
      "instants depends on the critical step, which is not the paper's, so that single values scatter.");
  reasons.push_back(
      "Decay rates: k and R² depend on the instants that enter the fit. Errors first grow and the few modes "
      "that are left at the end shrink at different rates, so R² is low and k uncertain in both.");
  const bool natural = std::any_of(input.bench.rows.begin(), input.bench.rows.end(), [](const BenchRow& row) {
    return row.integrator == "sts" && row.params.find("order=natural") != std::string::npos;
  });
  if (!natural)
    reasons.push_back(
        "We carry the substeps out in Leja order, which keeps rounding small; the paper takes them from the "
        "longest to the shortest. In exact arithmetic both are the same superstep.");
  std::string out = "<h4>Why the numbers differ</h4>\n<ul>\n";
  for (const auto& reason : reasons) out += fmt::format("<li>{}</li>\n", html_text(reason));
  return out + "</ul>\n";
}

}  // namespace

std::string paper_section(const CaseInput& input, const std::string& id) {
  const auto published = published_case(input.bench.source);
  if (!published) return {};
  const auto fields = fields_of(input.bench);
  const auto field = std::find_if(fields.begin(), fields.end(),
                                  [&](const CaseField& one) { return one.name == published->field; });
  std::string tables = paper_performance(input.bench, *published),
              figures = paper_speedup_figure(input.bench, *published, id);
  if (field != fields.end()) {
    const Number lambda_min = sample_figure(input.health, "lambda_min", "published");
    tables = paper_errors(input.bench, *published, *field, lambda_min) + tables;
    figures += paper_error_figure(input.bench, *published, *field, id);
  }
  if (tables.empty()) return {};
  return html_section(id + "-paper", "The paper side by side",
                      fmt::format("{}: published values beside those of this benchmark.", published->source),
                      sample_table(input.health) + tables + figure_row(figures) + differences(input));
}

}  // namespace superstep
