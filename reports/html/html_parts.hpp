#pragma once
/// Building blocks of the report's page.

#include <string>
#include <vector>

#include "results/text/plain_table.hpp"

namespace superstep {

/// <section> with a heading; empty when there is no body.
///   id     unique in the page;  intro  plain text below the heading, may be empty;  body  markup
[[nodiscard]] std::string html_section(const std::string& id, const std::string& title,
                                       const std::string& intro, const std::string& body);

/// Figures side by side where there is room.
[[nodiscard]] std::string figure_row(const std::string& figures);

/// A table; scripts may make it sortable.
class HtmlTable {
 public:
  struct Header {
    std::string title;   ///< plain text
    std::string hint{};  ///< what the column means, shown when pointed at
    bool number = true;  ///< aligned to the right
  };
  struct Cell {
    std::string text{};      ///< plain text
    std::string sort_key{};  ///< what to sort by when it is not the text
    std::string kind{};      ///< class: "good", "bad", "strong", ...
    std::string hint{};      ///< shown when pointed at
  };
  HtmlTable(std::vector<Header> headers, bool sortable) : headers_(std::move(headers)), sortable_(sortable) {}
  /// One cell per header.
  void add_row(std::vector<Cell> cells) { rows_.push_back(std::move(cells)); }
  [[nodiscard]] bool empty() const noexcept { return rows_.empty(); }
  [[nodiscard]] std::string html() const;

 private:
  std::vector<Header> headers_;
  std::vector<std::vector<Cell>> rows_;
  bool sortable_;
};

/// A cell with a number: shown with `digits`, sorted by its value; empty without one.
[[nodiscard]] HtmlTable::Cell number_cell(const double* value, int digits = 3);
template <class Optional>
[[nodiscard]] HtmlTable::Cell number_cell(const Optional& value, int digits = 3) {
  if (!value) return {};
  const auto number = static_cast<double>(*value);
  return number_cell(&number, digits);
}

[[nodiscard]] std::string plain_table_html(const PlainTable& table, bool sortable);

/// Names and values below each other, in two columns; `rows` are plain text.
[[nodiscard]] std::string fact_list(const std::vector<std::pair<std::string, std::string>>& rows);

}  // namespace superstep
