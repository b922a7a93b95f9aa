#pragma once
/// Tables of words, for the terminal, for Markdown and for the report.

#include <string>
#include <vector>

namespace superstep {

/// A table of words.
struct PlainTable {
  struct Cell {
    std::string text{};
    std::string kind{};  ///< "", "strong", "dim", "bad", "good"
    std::string hint{};  ///< more, where there is room for it
  };
  std::string id, title, intro;
  std::vector<std::string> headers{};
  std::vector<std::vector<Cell>> rows{};
};

[[nodiscard]] std::string terminal_text(const PlainTable& table, bool color);
/// Title, introduction and table in Markdown.
[[nodiscard]] std::string markdown_text(const PlainTable& table);

}  // namespace superstep
