#include "core/text/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "core/error.hpp"
#include "core/text/number.hpp"
#include "core/text/suggest.hpp"
#include "core/text/text_file.hpp"

namespace superstep {
namespace {

bool inside(const OptionKey& key, double value) noexcept {
  const bool above = key.min_open ? value > key.min : value >= key.min;
  const bool below = key.max_open ? value < key.max : value <= key.max;
  return above && below;
}

void check(const std::string& spec, const OptionKey& key, const std::string& value) {
  const bool is_word = std::find(key.words.begin(), key.words.end(), value) != key.words.end();
  if (is_word) return;
  bool valid = false;
  constexpr double largest_int = 2147483647.0;
  if (key.type == OptionKey::Type::number) {
    const auto number = parse_number(value);
    valid = number && inside(key, *number);
  } else if (key.type == OptionKey::Type::integer) {
    const auto number = parse_integer(value);
    valid =
        number && inside(key, static_cast<double>(*number)) && static_cast<double>(*number) <= largest_int;
  }
  if (!valid) {
    throw UsageError(fmt::format("{}: {} = {} is not valid; it must be {}{}{}", spec, key.name,
                                 in_quotes(value), key.type == OptionKey::Type::integer ? "an integer, " : "",
                                 key.range(), near_miss(value, key.words)));
  }
}

/// Name and settings of a SPEC, the latter sorted; it need not be valid.
std::vector<std::string> parts_of(const std::string& spec) {
  const std::size_t colon = std::min(spec.find(':'), spec.size());
  std::vector<std::string> parts;
  for (std::size_t begin = colon; begin < spec.size();) {
    const std::size_t end = std::min(spec.find(',', begin + 1), spec.size());
    parts.push_back(spec.substr(begin + 1, end - begin - 1));
    begin = end;
  }
  std::sort(parts.begin(), parts.end());
  parts.push_back(spec.substr(0, colon));
  return parts;
}

}  // namespace

std::string repeated_spec(std::span<const std::string> specs) {
  std::set<std::vector<std::string>> seen;
  for (const auto& spec : specs)
    if (!seen.insert(parts_of(spec)).second) return spec;
  return {};
}

std::string Spec::parameters() const {
  const std::size_t colon = text.find(':');
  return colon == std::string::npos ? std::string{} : text.substr(colon + 1);
}

Spec parse_spec(const std::string& text) {
  Spec spec;
  spec.text = text;
  const std::size_t colon = text.find(':');
  spec.name = text.substr(0, colon);
  const auto usage = [&](const std::string& what) {
    return UsageError(
        fmt::format("integrator {}: {}; write name or name:key=value,key=value", in_quotes(text), what));
  };
  if (spec.name.empty()) throw usage("the name is empty");
  if (spec.name.find(',') != std::string::npos)
    throw usage("a comma stands between settings, and several integrators are given apart, as in rkc rkl");
  if (colon == std::string::npos) return spec;
  std::string rest = text.substr(colon + 1);
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    const std::string setting = rest.substr(0, comma);
    more = comma != std::string::npos;
    if (more) rest.erase(0, comma + 1);
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw usage(fmt::format("setting {} has no '='", in_quotes(setting)));
    const std::string key = setting.substr(0, equals), value = setting.substr(equals + 1);
    if (key.empty() || value.empty())
      throw usage(fmt::format("setting {} lacks a key or a value", in_quotes(setting)));
    for (const auto& [earlier, ignored] : spec.settings)
      if (earlier == key) throw usage(fmt::format("key '{}' is given twice", key));
    spec.settings.emplace_back(key, value);
  }
  return spec;
}

std::string OptionKey::range() const {
  std::string out;
  if (type != Type::word) {
    const bool low = min > -std::numeric_limits<double>::infinity();
    const bool high = max < std::numeric_limits<double>::infinity();
    if (low && high)
      out = fmt::format("{} {} {} {} {}", min, min_open ? "<" : "<=", name, max_open ? "<" : "<=", max);
    else if (low)
      out = fmt::format("{} {} {}", name, min_open ? ">" : ">=", min);
    else if (high)
      out = fmt::format("{} {} {}", name, max_open ? "<" : "<=", max);
    else
      out = "a finite number";
    if (!unit.empty()) out += " " + unit;
    if (!words.empty()) out += " or ";
  }
  return out + fmt::format("{}", fmt::join(words, " | "));
}

Options::Options(Spec spec, std::span<const OptionKey> keys) : spec_(std::move(spec)) {
  std::vector<std::string> names;
  for (const auto& key : keys) {
    names.push_back(key.name);
    if (!key.fallback.empty()) defaults_.emplace_back(key.name, key.fallback);
  }
  for (const auto& [given, value] : spec_.settings) {
    const std::string& name = given;  // a lambda may not capture half of a pair
    const auto key =
        std::find_if(keys.begin(), keys.end(), [&](const OptionKey& k) { return k.name == name; });
    if (key == keys.end())
      throw UsageError(fmt::format("{}: unknown key {} = {}{}", spec_.name, in_quotes(name), in_quotes(value),
                                   suggestion(name, names)));
    check(spec_.name, *key, value);
  }
}

const std::string* Options::find(const std::string& key) const {
  for (const auto& [name, value] : spec_.settings)
    if (name == key) return &value;
  return nullptr;
}

bool Options::has(const std::string& key) const {
  return find(key) != nullptr;
}

std::optional<double> Options::given(const std::string& key) const {
  const auto* value = find(key);
  return value ? parse_number(*value) : std::nullopt;
}

double Options::number(const std::string& key) const {
  const auto value = parse_number(word(key));
  if (!value) throw std::logic_error(fmt::format("{}: {} has no number by default", spec_.name, key));
  return *value;
}

int Options::integer(const std::string& key) const {
  return static_cast<int>(number(key));  // checked: a whole number in the range of the table
}

const std::string& Options::word(const std::string& key) const {
  if (const auto* value = find(key)) return *value;
  for (const auto& [name, value] : defaults_)
    if (name == key) return value;
  throw std::logic_error(fmt::format("{}: {} has no default", spec_.name, key));
}

void Options::at_most_one_of(std::span<const std::string> keys) const {
  std::vector<std::string> given;
  for (const auto& key : keys)
    if (has(key)) given.push_back(key);
  if (given.size() > 1)
    throw UsageError(fmt::format("{}: keys {} exclude each other; give one of them", spec_.name,
                                 fmt::join(given, " and ")));
}

}  // namespace superstep
