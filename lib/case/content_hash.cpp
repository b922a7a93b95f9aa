#include "case/content_hash.hpp"

#include <array>
#include <filesystem>
#include <string_view>

#include "case/inputs/named_file.hpp"
#include "core/hash.hpp"
#include "core/text/text_file.hpp"

namespace superstep {
namespace {

bool changes_no_answer(std::string_view path) {
  constexpr std::array<std::string_view, 3> values = {"title", "source", "network.expect"};
  constexpr std::array<std::string_view, 3> tables = {"bench", "published", "corpus"};
  for (const auto value : values)
    if (path == value) return true;
  for (const auto table : tables)
    if (path == table || (path.starts_with(table) && path[table.size()] == '.')) return true;
  return false;
}

}  // namespace

std::string content_hash(const TomlTable& root) {
  ContentHash hash;
  for (const auto& leaf : root.leaves()) {
    if (changes_no_answer(leaf.path)) continue;
    hash.add(leaf.path).add(leaf.content);
    if (leaf.text.empty()) continue;
    const std::string file = beside_case(root.file(), leaf.text);
    std::error_code none;
    if (std::filesystem::is_regular_file(file, none)) hash.add(read_file(file));
  }
  return hash.text();
}

}  // namespace superstep
