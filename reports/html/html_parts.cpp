#include "reports/html/html_parts.hpp"

#include <fmt/format.h>

#include <utility>

#include "results/text/html_text.hpp"

namespace superstep {
namespace {

std::string attribute(const char* name, const std::string& value) {
  return value.empty() ? "" : fmt::format(R"( {}="{}")", name, html_text(value));
}

std::string cell_html(const HtmlTable::Cell& cell, const HtmlTable::Header& header, bool heads_row) {
  const std::string kind = (header.number ? "n " : "") + cell.kind;
  const char* tag = heads_row ? "th" : "td";
  return fmt::format("<{0}{1}{2}{3}{4}>{5}</{0}>", tag, heads_row ? R"( scope="row")" : "",
                     kind.empty() ? "" : attribute("class", kind), attribute("data-v", cell.sort_key),
                     attribute("title", cell.hint), html_text(cell.text));
}

}  // namespace

std::string html_section(const std::string& id, const std::string& title, const std::string& intro,
                         const std::string& body) {
  if (body.empty()) return {};
  const std::string paragraph =
      intro.empty() ? "" : fmt::format("<p class=\"intro\">{}</p>\n", html_text(intro));
  return fmt::format("<section id=\"{}\">\n<h3>{}</h3>\n{}{}</section>\n", html_text(id), html_text(title),
                     paragraph, body);
}

std::string figure_row(const std::string& figures) {
  return figures.empty() ? "" : "<div class=\"figures\">\n" + figures + "</div>\n";
}

std::string HtmlTable::html() const {
  std::string out =
      fmt::format("<div class=\"wide\"><table{}>\n<thead><tr>", sortable_ ? " class=\"sortable\"" : "");
  for (const auto& header : headers_)
    out += fmt::format("<th scope=\"col\"{}{}>{}</th>", header.number ? " class=\"n\"" : "",
                       attribute("title", header.hint), html_text(header.title));
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows_) {
    out += "<tr>";
    for (std::size_t k = 0; k < row.size(); ++k) out += cell_html(row[k], headers_[k], k == 0);
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

HtmlTable::Cell number_cell(const double* value, int digits) {
  if (!value) return {};
  return {.text = number_text(*value, digits), .sort_key = fmt::format("{}", *value)};
}

std::string plain_table_html(const PlainTable& table, bool sortable) {
  std::vector<HtmlTable::Header> headers;
  for (const auto& header : table.headers) headers.push_back({header, "", false});
  HtmlTable out(headers, sortable);
  for (const auto& row : table.rows) {
    std::vector<HtmlTable::Cell> cells;
    for (const auto& cell : row) cells.push_back({.text = cell.text, .kind = cell.kind, .hint = cell.hint});
    out.add_row(std::move(cells));
  }
  return out.html();
}

std::string fact_list(const std::vector<std::pair<std::string, std::string>>& rows) {
  if (rows.empty()) return {};
  std::string out = "<dl>\n";
  for (const auto& [name, value] : rows)
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", html_text(name), html_text(value));
  return out + "</dl>\n";
}

}  // namespace superstep
