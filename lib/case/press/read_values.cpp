#include "case/press/read_values.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text/suggest.hpp"

namespace superstep::dynamics {
namespace {

double at_least(const TomlValue& value, double least, const std::string& unit) {
  if (!(value.number() >= least)) value.reject(fmt::format("it must be >= {} [{}]", least, unit));
  return value.number();
}

}  // namespace

double number_from(TomlTable& table, const std::string& key, double least, double fallback,
                   const std::string& unit) {
  const auto value = table.find(key);
  return value ? at_least(*value, least, unit) : fallback;
}

double required_from(TomlTable& table, const std::string& key, double least, const std::string& unit) {
  return at_least(table.require(key, fmt::format("it must be a number >= {} [{}]", least, unit)), least,
                  unit);
}

double positive_or(TomlTable& table, const std::string& key, double fallback, const std::string& unit) {
  return table.find(key) ? table.positive(key, unit) : fallback;
}

bool boolean_or(TomlTable& table, const std::string& key, bool fallback) {
  const auto value = table.find(key);
  return value ? value->boolean() : fallback;
}

Vec3 point_from(const TomlValue& value) {
  const auto numbers = value.numbers();
  if (numbers.size() != 3) value.reject("it must be three numbers [x, y, z]");
  return {numbers[0], numbers[1], numbers[2]};
}

std::string word_from(TomlTable& table, const std::string& key, const std::vector<std::string>& words,
                      const std::string& fallback) {
  const auto value = table.find(key);
  if (!value) return fallback;
  const std::string word = value->string();
  if (std::find(words.begin(), words.end(), word) == words.end())
    value->reject("it must be one of the known words" + suggestion(word, words));
  return word;
}

TomlTable table_from(TomlTable& table, const std::string& key, const std::string& why) {
  (void)table.require(key, why).table();
  return *table.table(key);
}

}  // namespace superstep::dynamics
