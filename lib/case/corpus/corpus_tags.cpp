#include "case/corpus/corpus_tags.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "core/text/suggest.hpp"

namespace superstep {
namespace {

std::string word(TomlTable& table, const char* key, std::span<const char* const> words) {
  const TomlValue value = table.require(key, fmt::format("it is one of {}", fmt::join(words, ", ")));
  const std::string text = value.string();
  if (std::find(words.begin(), words.end(), text) == words.end())
    value.reject(fmt::format("it must be one of {}{}", fmt::join(words, ", "),
                             suggestion(text, std::vector<std::string>(words.begin(), words.end()))));
  return text;
}

}  // namespace

std::optional<CorpusTags> read_corpus_tags(TomlTable& root) {
  auto table = root.table("corpus");
  if (!table) return std::nullopt;
  CorpusTags tags;
  tags.set = word(*table, "set", corpus_sets);
  tags.scene_class = word(*table, "class", corpus_classes);
  tags.kind = table->require("kind", "it says what kind of network it is").string();
  tags.purpose = table->require("purpose", "it says in one line what the case is for").string();
  tags.unknowns = table->positive("unknowns", "-");
  tags.stiffness = table->positive("stiffness", "-");
  if (table->find("contrast")) tags.contrast = table->positive("contrast", "-");
  table->finish();
  return tags;
}

bool belongs_to(const CorpusTags& tags, const std::string& set) {
  const auto rank = [](const std::string& name) {
    return std::find(std::begin(corpus_sets), std::end(corpus_sets), name) - std::begin(corpus_sets);
  };
  return rank(tags.set) <= rank(set) && rank(set) < static_cast<std::ptrdiff_t>(std::size(corpus_sets));
}

}  // namespace superstep
