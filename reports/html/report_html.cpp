#include "reports/html/report_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reports/html/embedded.hpp"
#include "reports/html/sections/sections.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

/// The page with every {{name}} of the template replaced; what is put in is not looked at again.
std::string filled(std::string_view page, const std::map<std::string_view, std::string>& values) {
  std::string out;
  for (;;) {
    const std::size_t begin = page.find("{{"), end = page.find("}}", begin);
    if (begin == std::string_view::npos || end == std::string_view::npos) break;
    out.append(page.substr(0, begin));
    const auto value = values.find(page.substr(begin + 2, end - begin - 2));
    if (value != values.end()) out.append(value->second);
    page.remove_prefix(end + 2);
  }
  return out.append(page);
}

// The only case of a page has its name at the top already.
std::string case_html(const CaseInput& input, const std::string& id, bool only) {
  const BenchCase& one = input.bench;
  const std::string title = only ? "The benchmark" : one.title.empty() ? one.name : one.title;
  std::string out = fmt::format("<article id=\"{}\">\n<h2>{}</h2>\n", id, html_text(title));
  out += answer_section(input, id) + case_section(input, id) + results_section(input, id) +
         speed_section(input, id);
  if (input.work_precision) out += work_precision_section(*input.work_precision, id);
  out += probe_section(input, id) + error_section(input, id) + sts_section(input, id) +
         paper_section(input, id) + skipped_section(input, id);
  return out + "</article>\n";
}

std::string general_title(const ReportInput& input) {
  if (input.stability) return input.runs.empty() ? "Stability and machine" : "Stability, runs and machine";
  return input.runs.empty() ? "Machine" : "Runs and machine";
}

std::string body_of(const ReportInput& input) {
  std::string out;
  for (std::size_t k = 0; k < input.cases.size(); ++k)
    out += case_html(input.cases[k], fmt::format("case-{}", k + 1), input.cases.size() == 1);
  if (!input.corpus.empty()) out += corpus_article(input.corpus);
  out += sintering_articles(input.runs);
  if (!input.press_table.empty()) out += press_table_article(input.press_table);
  std::string rest;
  for (std::size_t k = 0; k < input.other_studies.size(); ++k)
    rest += work_precision_section(input.other_studies[k], fmt::format("study-{}", k + 1));
  if (input.stability) rest += stability_section(*input.stability);
  rest += runs_section(input.runs) + machine_section(input);
  if (rest.empty()) return out;
  return out +
         fmt::format("<article id=\"general\">\n<h2>{}</h2>\n{}</article>\n", general_title(input), rest);
}

/// Links to the sections, read off the finished body so that none leads nowhere.
std::string contents_of(const std::string& body) {
  std::string out;
  constexpr std::string_view section = "<section id=\"", article = "<article id=\"";
  for (std::size_t at = 0; (at = body.find('<', at)) != std::string::npos; ++at) {
    const std::string_view rest = std::string_view(body).substr(at);
    const bool chapter = rest.starts_with(article);
    if (!chapter && !rest.starts_with(section)) continue;
    const std::size_t id_begin = (chapter ? article : section).size();
    const std::string_view id = rest.substr(id_begin, rest.find('"', id_begin) - id_begin);
    const std::string_view open = chapter ? "<h2>" : "<h3>", close = chapter ? "</h2>" : "</h3>";
    const std::size_t title = rest.find(open) + open.size();
    out += fmt::format("<a{} href=\"#{}\">{}</a>\n", chapter ? " class=\"chapter\"" : "", id,
                       rest.substr(title, rest.find(close) - title));
  }
  return out;
}

std::string heading_of(const ReportInput& input) {
  if (input.cases.size() == 1)
    return input.cases.front().bench.title.empty() ? input.cases.front().bench.name
                                                   : input.cases.front().bench.title;
  if (!input.cases.empty()) return fmt::format("{} cases", input.cases.size());
  if (!input.corpus.empty()) return "Which method for which scenes";
  if (!input.press_table.empty()) return "Hold and densification";
  if (input.runs.empty()) return "Results";
  const std::string& title = input.runs.front().record.title;
  const bool same = std::all_of(input.runs.begin(), input.runs.end(),
                                [&](const RunInput& run) { return run.record.title == title; });
  return same ? title : fmt::format("{} runs", input.runs.size());
}

/// The chart library with its licence, which asks to be kept with it.
std::string library_text() {
  const std::string_view code = embedded_file("uPlot.iife.min.js");
  if (code.empty()) return {};
  return fmt::format("/*\n{}*/\n{}", embedded_file("LICENSE"), code);
}

std::string notice_of(const ReportInput& input) {
  std::string out;
  if (input.bench && input.bench->interrupted)
    out +=
        "<p class=\"notice\">The benchmark was interrupted; what had been measured by then is shown.</p>\n";
  if (embedded_file("uPlot.iife.min.js").empty())
    out += "<p class=\"notice\">This program was built without its chart library: charts are static.</p>\n";
  return out;
}

}  // namespace

std::string report_html(const ReportInput& input) {
  const std::string body = body_of(input);
  return filled(embedded_file("page.html"), {{"title", html_text(heading_of(input))},
                                             {"style", std::string(embedded_file("report.css"))},
                                             {"library_style", std::string(embedded_file("uPlot.min.css"))},
                                             {"notice", notice_of(input)},
                                             {"contents", contents_of(body)},
                                             {"body", body},
                                             {"library", library_text()},
                                             {"script", std::string(embedded_file("report.js"))}});
}

}  // namespace superstep
