#include "bench/harness/corpus/corpus_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "core/error.hpp"
#include "core/shared_library.hpp"
#include "core/text/text_file.hpp"

namespace superstep {
namespace {

namespace fs = std::filesystem;

bool is_set(const std::string& name) {
  return std::find(std::begin(corpus_sets), std::end(corpus_sets), name) != std::end(corpus_sets);
}

/// A case of somebody's own.
CorpusTags no_tags() {
  return {.set = "own", .scene_class = "own", .kind = "own", .purpose = {}};
}

}  // namespace

std::string corpus_folder() {
  const fs::path below = fs::path("cases") / "corpus";
  std::error_code none;
  if (fs::is_directory(below, none)) return below.string();
  const fs::path program = fs::path(program_file()).parent_path();
  if (const fs::path installed = program.parent_path() / "share" / "superstep" / below;
      fs::is_directory(installed, none))
    return installed.string();
  for (fs::path above = program; above.has_relative_path(); above = above.parent_path())
    if (fs::is_directory(above / below, none)) return (above / below).string();
  throw UsageError(
      "bench: the corpus is not here: go to the folder that holds cases/corpus, or give a folder of cases: "
      "--corpus DIR");
}

std::vector<CorpusFile> corpus_files(const std::string& set_or_folder) {
  const bool set = is_set(set_or_folder);
  const std::string folder = set ? corpus_folder() : set_or_folder;
  std::error_code none;
  if (!fs::is_directory(folder, none))
    throw UsageError(fmt::format("bench: --corpus {}: it must be quick, standard, large or a folder of cases",
                                 superstep::in_quotes(folder)));
  std::vector<CorpusFile> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    TomlTable root = TomlTable::parse_file(entry.path().string());
    const auto tags = read_corpus_tags(root);
    if (set && !tags)
      throw InputError(fmt::format("{}: [corpus] is missing; every case of the corpus has its tags",
                                   entry.path().string()));
    if (!set || belongs_to(*tags, set_or_folder))
      files.push_back({entry.path().string(), tags.value_or(no_tags())});
  }
  if (files.empty())
    throw UsageError(fmt::format("bench: there is no case (*.toml) in {}", superstep::in_quotes(folder)));
  std::sort(files.begin(), files.end(), [](const CorpusFile& a, const CorpusFile& b) {
    return std::tie(a.tags.unknowns, a.path) < std::tie(b.tags.unknowns, b.path);
  });
  return files;
}

}  // namespace superstep
