#pragma once
/// corpus.csv: written, and read back.

#include <span>
#include <string>
#include <vector>

#include "results/corpus/corpus_row.hpp"

namespace superstep {

[[nodiscard]] std::string corpus_csv(std::span<const CorpusRow> rows);

/// Throws InputError with file, row and rule.
[[nodiscard]] std::vector<CorpusRow> read_corpus_csv(const std::string& path);

}  // namespace superstep
