#pragma once
/// A corpus as plain tables: the terminal, Markdown and the report show the same ones.

#include <span>
#include <string>
#include <vector>

#include "results/corpus/corpus_row.hpp"
#include "results/text/plain_table.hpp"

namespace superstep {

/// One line about what was measured.
[[nodiscard]] std::string corpus_headline(std::span<const CorpusRow> rows);

/// The map, the winners of every scene, profiles, `auto`, and what failed; tables without rows are left out.
[[nodiscard]] std::vector<PlainTable> corpus_tables(std::span<const CorpusRow> rows);

}  // namespace superstep
