#include "core/text/toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "core/error.hpp"
#include "core/text/suggest.hpp"
#include "core/text/text_file.hpp"
#include "core/text/toml_parser.hpp"

namespace superstep {
namespace {

constexpr std::size_t largest_case_file = 4u
                                          << 20;  // bytes; a case names its data files, it does not hold them

std::string shown_node(const toml::node& node) {
  if (const auto* text = node.as_string()) return in_quotes(text->get());
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  return "a date or time";
}

/// What steers a terminal: C0 but for tabs and ends of lines, and C1, which is C2 80 to C2 9F in UTF-8.
/// Terminals ignore DEL.
bool holds_control_characters(std::string_view text) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto byte = static_cast<unsigned char>(text[k]);
    if (byte < 0x20 && text[k] != '\t' && text[k] != '\n' && text[k] != '\r') return true;
    const auto next = static_cast<unsigned char>(k + 1 < text.size() ? text[k + 1] : '\0');
    if (byte == 0xC2 && next >= 0x80 && next < 0xA0) return true;
  }
  return false;
}

bool parser_gives_up(std::string_view text) {
  try {
    static_cast<void>(toml::parse(text));
  } catch (const toml::parse_error&) {
  } catch (const TomlAssertion&) {
    return true;
  }
  return false;
}

/// First line whose text makes the parser give up: the parser reads in order, so a prefix decides it.
std::size_t malformed_line(std::string_view text) {
  std::vector<std::size_t> ends;  // of line k+1
  for (std::size_t k = text.find('\n'); k != std::string_view::npos; k = text.find('\n', k + 1))
    ends.push_back(k);
  const auto first = std::partition_point(
      ends.begin(), ends.end(), [&](std::size_t end) { return !parser_gives_up(text.substr(0, end)); });
  return static_cast<std::size_t>(first - ends.begin()) + 1;
}

void collect(const toml::node& node, const std::string& path, std::vector<TomlTable::Leaf>& out) {
  const auto add = [&](std::string content, std::string text = {}) {
    out.push_back({path, std::move(content), std::move(text)});
  };
  if (const auto* table = node.as_table()) {
    if (table->empty()) add("table");
    for (const auto& [key, value] : *table)
      collect(value, path.empty() ? std::string(key.str()) : fmt::format("{}.{}", path, key.str()), out);
  } else if (const auto* array = node.as_array()) {
    if (array->empty()) add("array");
    for (std::size_t k = 0; k < array->size(); ++k)
      collect(*array->get(k), fmt::format("{}[{}]", path, k), out);
  } else if (const auto* text = node.as_string()) {
    add("string " + text->get(), text->get());
  } else if (const auto* whole = node.as_integer()) {
    const auto number = static_cast<double>(whole->get());
    const bool is_exact = number < 0x1p63 && static_cast<std::int64_t>(number) == whole->get();
    add(is_exact ? fmt::format("number {:a}", number) : fmt::format("integer {}", whole->get()));
  } else if (const auto* number = node.as_floating_point()) {
    add(fmt::format("number {:a}", number->get()));
  } else if (const auto* truth = node.as_boolean()) {
    add(truth->get() ? "true" : "false");
  } else {
    std::ostringstream date;
    date << toml::node_view<const toml::node>(node);
    add("date " + date.str());
  }
}

}  // namespace

/// A parsed file, and the keys that were asked for in every table of it that somebody has read.
struct TomlDocument {
  toml::table root;
  std::string file;
  bool has_lines = true;  // that its user knows
  struct Asked {
    std::string path;  // "a.b[2]"
    std::set<std::string> keys;
  };
  std::map<const toml::table*, Asked> asked;

  [[nodiscard]] std::string place(const toml::source_region& source) const {
    return has_lines ? fmt::format("{}:{}", file, source.begin.line) : file;
  }
  [[nodiscard]] std::string in(const std::string& path) const {
    return path.empty() ? "" : fmt::format(" in [{}]", path);
  }
  [[noreturn]] void reject_key(const toml::key& key, const std::string& path,
                               std::span<const std::string> valid) const {
    const std::string name(key.str());
    throw InputError(fmt::format("{}: unknown key {}{}{}", place(key.source()), in_quotes(name), in(path),
                                 suggestion(name, valid)));
  }
};

struct TomlValue::Node {
  std::shared_ptr<TomlDocument> document;  // keeps `node` alive
  const toml::node* node;
  std::string path;
};

struct TomlTable::Data {
  std::shared_ptr<TomlDocument> document;
  const toml::table* table;
  TomlDocument::Asked& asked;  // one for all who read this table
};

bool TomlValue::is_number() const noexcept {
  return node_->node->is_number();
}
bool TomlValue::is_integer() const noexcept {
  return node_->node->is_integer();
}
bool TomlValue::is_string() const noexcept {
  return node_->node->is_string();
}
bool TomlValue::is_array() const noexcept {
  return node_->node->is_array();
}
bool TomlValue::is_table() const noexcept {
  return node_->node->is_table();
}

const std::string& TomlValue::file() const noexcept {
  return node_->document->file;
}

std::string TomlValue::where() const {
  return fmt::format("{}: key '{}'", node_->document->place(node_->node->source()), node_->path);
}

std::string TomlValue::shown() const {
  return shown_node(*node_->node);
}

void TomlValue::reject(const std::string& rule) const {
  throw InputError(fmt::format("{} is {}; {}", where(), shown(), rule));
}

double TomlValue::number() const {
  if (!is_number()) reject("it must be a number");
  const double value = is_integer() ? static_cast<double>(node_->node->as_integer()->get())
                                    : node_->node->as_floating_point()->get();
  if (!std::isfinite(value)) reject("it must be finite");
  if (std::abs(value) > largest_number)
    reject(fmt::format("it must not exceed {:g} in size, beyond which nothing can be computed with",
                       largest_number));
  return value;
}

std::int64_t TomlValue::integer() const {
  if (!is_integer()) reject("it must be an integer");
  return node_->node->as_integer()->get();
}

bool TomlValue::boolean() const {
  if (!node_->node->is_boolean()) reject("it must be true or false");
  return node_->node->as_boolean()->get();
}

std::string TomlValue::string() const {
  if (!is_string()) reject("it must be a string");
  if (node_->node->as_string()->get().empty()) reject("it must not be empty; leave the key out");
  const std::string& text = node_->node->as_string()->get();
  if (holds_control_characters(text))
    reject("it must not hold control characters, which steer a terminal; leave them out");
  return text;
}

std::vector<TomlValue> TomlValue::array() const {
  const auto* elements = node_->node->as_array();
  if (!elements) reject("it must be an array");
  std::vector<TomlValue> values;
  for (std::size_t k = 0; k < elements->size(); ++k)
    values.push_back(TomlValue(std::make_shared<const Node>(
        Node{node_->document, elements->get(k), fmt::format("{}[{}]", node_->path, k)})));
  return values;
}

std::vector<double> TomlValue::numbers() const {
  std::vector<double> out;
  for (const auto& value : array()) out.push_back(value.number());
  return out;
}

std::vector<std::string> TomlValue::strings() const {
  std::vector<std::string> out;
  for (const auto& value : array()) out.push_back(value.string());
  return out;
}

TomlTable TomlValue::table() const {
  if (!is_table()) reject("it must be a table");
  const auto* table = node_->node->as_table();
  auto& asked = node_->document->asked.try_emplace(table, TomlDocument::Asked{node_->path, {}}).first->second;
  return TomlTable(std::make_shared<TomlTable::Data>(TomlTable::Data{node_->document, table, asked}));
}

TomlTable TomlTable::parse_file(const std::string& path) {
  return parse_text(read_text_file(path, largest_case_file), path);
}

TomlTable TomlTable::parse_text(const std::string& text, const std::string& path) {
  return parse(text, path, true);
}

TomlTable TomlTable::parse_unseen(const std::string& text, const std::string& path) {
  return parse(text, path, false);
}

TomlTable TomlTable::parse(const std::string& text, const std::string& path, bool has_lines) {
  if (text.size() > largest_case_file)
    throw InputError(
        fmt::format("{}: has {} bytes; a case file has at most {}: keep data in files of its own", path,
                    text.size(), largest_case_file));
  try {
    auto document = std::make_shared<TomlDocument>(
        TomlDocument{toml::parse(std::string_view(text), path), path, has_lines, {}});
    const toml::table* table = &document->root;
    auto& asked = document->asked[table];
    return TomlTable(std::make_shared<Data>(Data{std::move(document), table, asked}));
  } catch (const toml::parse_error& error) {
    throw InputError(
        fmt::format("{}:{}: is not valid TOML: {}", path, error.source().begin.line, error.description()));
  } catch (const TomlAssertion&) {
    throw InputError(
        fmt::format("{}:{}: is not valid TOML: malformed key or table name", path, malformed_line(text)));
  }
}

std::optional<TomlValue> TomlTable::find(const std::string& key) {
  auto& asked = data_->asked;
  asked.keys.insert(key);
  const toml::node* node = data_->table->get(key);
  if (!node) return std::nullopt;
  const std::string path = asked.path.empty() ? key : asked.path + "." + key;
  return TomlValue(std::make_shared<const TomlValue::Node>(TomlValue::Node{data_->document, node, path}));
}

TomlValue TomlTable::require(const std::string& key, const std::string& why) {
  auto value = find(key);
  if (!value) missing(key, fmt::format("key '{}' is missing; {}", key, why));
  return *value;
}

void TomlTable::missing(const std::string& key, const std::string& what) const {
  std::vector<std::string> wanted(data_->asked.keys.begin(), data_->asked.keys.end());
  wanted.push_back(key);
  for (const auto& [other, node] : *data_->table) {
    const std::string name(other.str());
    if (!data_->asked.keys.contains(name) && !nearest_by_spelling(name, wanted).empty())
      data_->document->reject_key(other, data_->asked.path, wanted);
  }
  throw InputError(fmt::format("{}: {}", where(), what));
}

std::optional<double> TomlTable::number(const std::string& key) {
  const auto value = find(key);
  return value ? std::optional<double>(value->number()) : std::nullopt;
}

double TomlTable::positive(const std::string& key, const std::string& unit) {
  const auto value = require(key, fmt::format("it must be a number > 0 [{}]", unit));
  if (!(value.number() > 0)) value.reject(fmt::format("it must be > 0 [{}]", unit));
  return value.number();
}

std::optional<std::string> TomlTable::string(const std::string& key) {
  const auto value = find(key);
  return value ? std::optional<std::string>(value->string()) : std::nullopt;
}

std::optional<TomlTable> TomlTable::table(const std::string& key) {
  const auto value = find(key);
  return value ? std::optional<TomlTable>(value->table()) : std::nullopt;
}

void TomlTable::finish() const {
  const auto& document = *data_->document;
  const std::string& here = data_->asked.path;
  const auto below = [&](const std::string& path) {
    return here.empty() || path == here || path.starts_with(here + ".") || path.starts_with(here + "[");
  };
  const toml::key* first = nullptr;  // in the order of the file
  const TomlDocument::Asked* owner = nullptr;
  for (const auto& [table, asked] : document.asked) {
    if (!below(asked.path)) continue;
    for (const auto& [key, node] : *table) {
      const bool known = asked.keys.contains(std::string(key.str()));
      if (known || (first && first->source().begin < key.source().begin)) continue;
      first = &key;
      owner = &asked;
    }
  }
  if (!first) return;
  const std::vector<std::string> valid(owner->keys.begin(), owner->keys.end());
  document.reject_key(*first, owner->path, valid);
}

std::string TomlTable::where() const {
  const auto& [path, keys] = data_->asked;
  const auto& document = *data_->document;
  if (path.empty()) return document.has_lines ? fmt::format("{}:1", file()) : file();
  return fmt::format("{}: [{}]", document.place(data_->table->source()), path);
}

std::vector<TomlTable::Leaf> TomlTable::leaves() const {
  std::vector<Leaf> all;
  collect(*data_->table, data_->asked.path, all);
  std::sort(all.begin(), all.end(), [](const Leaf& a, const Leaf& b) { return a.path < b.path; });
  return all;
}

std::vector<std::string> TomlTable::asked_keys() const {
  std::vector<std::string> places;
  for (const auto& [table, asked] : data_->document->asked)
    for (const auto& key : asked.keys) places.push_back(asked.path.empty() ? key : asked.path + "." + key);
  return places;
}

const std::string& TomlTable::file() const noexcept {
  return data_->document->file;
}

}  // namespace superstep
