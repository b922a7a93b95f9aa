#pragma once
/// Which cases a corpus holds.

#include <string>
#include <vector>

#include "case/corpus/corpus_tags.hpp"

namespace superstep {

struct CorpusFile {
  std::string path;
  CorpusTags tags;
};

/// Folder of the corpus that comes with the program: cases/corpus here, beside the installed program, or
/// above the built one. Throws UsageError when there is none.
[[nodiscard]] std::string corpus_folder();

/// Cases of a set ("quick", "standard", "large"), or all cases of a folder, which need no tags; the smallest
/// first. Throws UsageError, and InputError about a case.
[[nodiscard]] std::vector<CorpusFile> corpus_files(const std::string& set_or_folder);

}  // namespace superstep
