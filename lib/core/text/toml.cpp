#include "core/text/toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "core/error.hpp"
#include "core/text/suggest.hpp"
#include "core/text/text_file.hpp"

// toml++ 3.3.0 meets some malformed input with a failed assertion. Compiled into this file alone, with
// assertions that throw (NDEBUG would turn them into undefined behaviour).
namespace superstep {
namespace {
struct TomlAssertion : std::logic_error {
  using std::logic_error::logic_error;
};
[[noreturn]] void toml_assertion_failed(const char* what) {
  throw TomlAssertion(what);
}
}  // namespace
}  // namespace superstep
#undef NDEBUG
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 1
#define TOML_MAX_NESTED_VALUES 32
#define TOML_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : superstep::toml_assertion_failed(#condition))
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wterminate"
#include <toml++/toml.h>
#pragma GCC diagnostic pop

namespace superstep {
namespace {

constexpr std::size_t largest_case_file = 4u
                                          << 20;  // bytes; a case names its data files, it does not hold them

std::string place(const std::string& file, const toml::node& node) {
  return fmt::format("{}:{}", file, node.source().begin.line);
}

std::string shown_node(const toml::node& node) {
  if (const auto* text = node.as_string()) return quoted(text->get());
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  return "a date or time";
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
    add(static_cast<std::int64_t>(number) == whole->get() ? fmt::format("number {:a}", number)
                                                          : fmt::format("integer {}", whole->get()));
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

struct TomlValue::Node {
  std::shared_ptr<const toml::table> root;  // keeps `node` alive
  const toml::node* node;
  std::string file, path;
};

struct TomlTable::Data {
  std::shared_ptr<const toml::table> root;
  const toml::table* table;
  std::string file, path;
  std::set<std::string> known;
  std::map<std::string, TomlTable>
      children;  // one object per sub-table, so that all askers share what is known
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

std::string TomlValue::where() const {
  return fmt::format("{}: key '{}'", place(node_->file, *node_->node), node_->path);
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
  return node_->node->as_string()->get();
}

std::vector<TomlValue> TomlValue::array() const {
  const auto* elements = node_->node->as_array();
  if (!elements) reject("it must be an array");
  std::vector<TomlValue> values;
  for (std::size_t k = 0; k < elements->size(); ++k)
    values.push_back(TomlValue(std::make_shared<const Node>(
        Node{node_->root, elements->get(k), node_->file, fmt::format("{}[{}]", node_->path, k)})));
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
  return TomlTable(std::make_shared<TomlTable::Data>(
      TomlTable::Data{node_->root, node_->node->as_table(), node_->file, node_->path, {}, {}}));
}

TomlTable TomlTable::parse_file(const std::string& path) {
  return parse_text(read_text_file(path), path);
}

TomlTable TomlTable::parse_text(const std::string& text, const std::string& path) {
  if (text.size() > largest_case_file)
    throw InputError(
        fmt::format("{}: has {} bytes; a case file has at most {}: keep data in files of its own", path,
                    text.size(), largest_case_file));
  try {
    auto root = std::make_shared<const toml::table>(toml::parse(std::string_view(text), path));
    const toml::table* table = root.get();
    return TomlTable(std::make_shared<Data>(Data{std::move(root), table, path, "", {}, {}}));
  } catch (const toml::parse_error& error) {
    throw InputError(
        fmt::format("{}:{}: is not valid TOML: {}", path, error.source().begin.line, error.description()));
  } catch (const TomlAssertion&) {
    throw InputError(
        fmt::format("{}:{}: is not valid TOML: malformed key or table name", path, malformed_line(text)));
  }
}

std::optional<TomlValue> TomlTable::find(const std::string& key) {
  data_->known.insert(key);
  const toml::node* node = data_->table->get(key);
  if (!node) return std::nullopt;
  const std::string path = data_->path.empty() ? key : data_->path + "." + key;
  return TomlValue(
      std::make_shared<const TomlValue::Node>(TomlValue::Node{data_->root, node, data_->file, path}));
}

TomlValue TomlTable::require(const std::string& key, const std::string& why) {
  auto value = find(key);
  if (!value) throw InputError(fmt::format("{}: key '{}' is missing; {}", where(), key, why));
  return *value;
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
  if (!value) return std::nullopt;
  const auto [child, inserted] = data_->children.try_emplace(key, value->table());
  return child->second;
}

void TomlTable::finish() const {
  const std::vector<std::string> known(data_->known.begin(), data_->known.end());
  for (const auto& [key, node] : *data_->table) {
    const std::string name(key.str());
    if (!data_->known.contains(name))
      throw InputError(fmt::format(
          "{}: unknown key {}{}{}", fmt::format("{}:{}", data_->file, key.source().begin.line), quoted(name),
          data_->path.empty() ? "" : fmt::format(" in [{}]", data_->path), suggestion(name, known)));
  }
  for (const auto& [key, child] : data_->children) child.finish();
}

std::string TomlTable::where() const {
  const auto line = data_->table->source().begin.line;
  return data_->path.empty() ? fmt::format("{}:1", data_->file)
                             : fmt::format("{}:{}: [{}]", data_->file, line, data_->path);
}

std::vector<TomlTable::Leaf> TomlTable::leaves() const {
  std::vector<Leaf> all;
  collect(*data_->table, data_->path, all);
  std::sort(all.begin(), all.end(), [](const Leaf& a, const Leaf& b) { return a.path < b.path; });
  return all;
}

const std::string& TomlTable::file() const noexcept {
  return data_->file;
}

}  // namespace superstep
