#include "bad_inputs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <regex>
#include <utility>

namespace superstep::test {
namespace {

void collect(const Tree& tree, const std::string& path, std::vector<std::pair<std::string, Tree>>& out) {
  if (tree.is_object()) {
    for (const auto& [name, value] : tree.items()) {
      const std::string place = path.empty() ? name : path + "." + name;
      out.emplace_back(place, value);
      collect(value, place, out);
    }
  } else if (tree.is_array()) {
    for (std::size_t k = 0; k < tree.size(); ++k) collect(tree[k], fmt::format("{}[{}]", path, k), out);
  }
}

/// A value of each type, as TOML.
constexpr std::pair<unsigned, const char*> samples[] = {
    {CaseKey::number, "1.5"},   {CaseKey::integer, "3"},    {CaseKey::boolean, "true"},
    {CaseKey::text, "\"1.5\""}, {CaseKey::array, "[ [] ]"}, {CaseKey::table, "{ zzz = 1 }"},
    {0, "2026-01-31"}};

/// Values that are of none of the types.
std::vector<std::string> of_other_types(unsigned types) {
  if (types & CaseKey::number) types |= CaseKey::integer;
  std::vector<std::string> out;
  for (const auto& [type, sample] : samples)
    if ((types & type) == 0) out.emplace_back(sample);
  return out;
}

/// Numbers outside the range, and what is no number.
std::vector<std::string> bad_numbers(const CaseKey& key, bool whole) {
  std::vector<std::string> out = {"nan", "inf", "-inf", "1e300", "1e999", "99999999999999999999", "1_", "0x"};
  const auto show = [&](double value) {
    return whole ? fmt::format("{:.0f}", value) : fmt::format("{:e}", value);
  };
  if (std::isfinite(key.min)) {
    out.push_back(show(key.min - 1));
    if (key.min_open) out.push_back(show(key.min));
    if (!whole) out.push_back(show(key.min - 1e-6 * std::max(1.0, std::abs(key.min))));
  }
  if (std::isfinite(key.max)) {
    out.push_back(show(key.max + std::max(1.0, 1e-6 * std::abs(key.max))));
    if (key.max_open) out.push_back(show(key.max));
    if (!whole) out.push_back(show(key.max + 1e-6 * std::max(1.0, std::abs(key.max))));
  }
  return out;
}

std::string joined(std::vector<std::string> elements) {
  std::string out = "[";
  for (const auto& element : elements) out += (out.size() > 1 ? ", " : "") + element;
  return out + "]";
}

/// The array with one element that is wrong, and arrays of a wrong length.
std::vector<std::string> bad_arrays(const CaseKey& key, const Tree& value) {
  std::vector<std::string> out, elements, wrong = of_other_types(key.elements);
  if (!value.is_array() || value.empty()) return out;
  for (const auto& element : value) elements.push_back(toml_value(element));
  if (key.elements & CaseKey::number)
    for (auto& number : bad_numbers(key, false)) wrong.push_back(std::move(number));
  for (const auto& element : wrong) {
    auto changed = elements;
    changed.back() = element;
    out.push_back(joined(changed));
  }
  if (key.count > 0) {
    auto longer = elements;
    longer.push_back(elements.back());
    out.push_back(joined(longer));
    elements.pop_back();
    out.push_back(joined(elements));
  }
  return out;
}

}  // namespace

std::vector<std::pair<std::string, Tree>> places_of(const Tree& root) {
  std::vector<std::pair<std::string, Tree>> out;
  collect(root, "", out);
  return out;
}

std::string general_place(const std::string& place) {
  static const std::regex index("\\[[0-9]+\\]");
  return std::regex_replace(place, index, "[]");
}

std::vector<BadInput> bad_inputs(const CaseKey& key, const std::string& place, const Tree& value) {
  const std::string name = key.name(), right = toml_value(value);
  std::vector<BadInput> out;
  const auto instead = [&](const std::string& what, const std::string& wrong) {
    out.push_back({what, {place, name, wrong, ""}});
  };
  for (const auto& wrong : of_other_types(key.types)) instead("another type", wrong);
  instead("no value", "");
  if (key.types & CaseKey::number)
    for (const auto& wrong : bad_numbers(key, false)) instead("a bad number", wrong);
  else if (key.types & CaseKey::integer)
    for (const auto& wrong : bad_numbers(key, true)) instead("a bad integer", wrong);
  if (key.types & CaseKey::array)
    for (const auto& wrong : bad_arrays(key, value)) instead("a bad array", wrong);
  if ((key.types & CaseKey::text) && !key.may_be_empty) instead("an empty text", "\"\"");
  if ((key.types & CaseKey::array) && !key.may_be_empty) instead("an empty array", "[]");
  if (!key.words.empty()) instead("an unknown word", "\"nonsense\"");
  if (key.types & CaseKey::table) instead("an unknown key in it", "{ zzz = 1 }");
  out.push_back({"another name", {place, name + "q", right, ""}});
  out.push_back({"twice", {place, name, right, name + " = " + right}});
  out.push_back({"an unknown neighbour", {place, name, right, "zzz_" + name + " = 1"}});
  return out;
}

}  // namespace superstep::test
