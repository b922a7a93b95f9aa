#include "case/keys/case_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "case/keys/key_list.hpp"
#include "core/text/options.hpp"

namespace superstep {
namespace {

constexpr std::pair<unsigned, const char*> type_names[] = {
    {CaseKey::number, "number"},   {CaseKey::integer, "integer"},
    {CaseKey::boolean, "boolean"}, {CaseKey::text, "text"},
    {CaseKey::table, "table"},     {CaseKey::array, "array"}};  // whose elements follow

std::string names_of(unsigned types, const char* plural) {
  std::vector<std::string> names;
  for (const auto& [type, name] : type_names)
    if (types & type) names.push_back(std::string(name) + plural);
  return fmt::format("{}", fmt::join(names, " or "));
}

}  // namespace

std::string CaseKey::name() const {
  const auto dot = place.rfind('.');
  return dot == std::string::npos ? place : place.substr(dot + 1);
}

std::string CaseKey::type_text() const {
  std::string out = names_of(types, "");
  if (!(types & array)) return out;
  return out + " of " + (count > 0 ? fmt::format("{} ", count) : "") + names_of(elements, "s");
}

std::string CaseKey::range_text() const {
  const bool bounded =
      min > -std::numeric_limits<double>::infinity() || max < std::numeric_limits<double>::infinity();
  std::string out;
  if (bounded)
    out =
        OptionKey{.name = name(), .min = min, .max = max, .min_open = min_open, .max_open = max_open}.range();
  if (!words.empty()) out += fmt::format("{}{}", bounded ? " or " : "", fmt::join(words, " \\| "));
  return out;
}

std::vector<std::string> CaseKey::scene_names() const {
  std::vector<std::string> names;
  for (const auto& [scene, name] : {std::pair{packing, "packing"}, {network, "network"}, {press, "press"}})
    if (scenes & scene) names.emplace_back(name);
  return names;
}

std::span<const CaseKey> case_keys() {
  static const std::vector<CaseKey> keys = [] {
    KeyList list;
    list_common_keys(list);
    list_corpus_keys(list);
    list_packing_keys(list);
    list_field_keys(list);
    list_press_keys(list);
    return list.take();
  }();
  return keys;
}

}  // namespace superstep
