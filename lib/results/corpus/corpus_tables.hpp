#pragma once
/// A corpus as plain tables: the terminal, Markdown and the report show the same ones.

#include <span>
#include <string>
#include <vector>

#include "results/corpus/corpus_row.hpp"

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

/// One line about what was measured.
[[nodiscard]] std::string corpus_headline(std::span<const CorpusRow> rows);

/// The map, the winners of every scene, profiles, `auto`, and what failed; tables without rows are left out.
[[nodiscard]] std::vector<PlainTable> corpus_tables(std::span<const CorpusRow> rows);

[[nodiscard]] std::string terminal_text(const PlainTable& table, bool color);
/// Title, introduction and table in Markdown.
[[nodiscard]] std::string markdown_text(const PlainTable& table);

}  // namespace superstep
