#include "results/text/json_object.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "results/text/csv_text.hpp"

namespace superstep {
namespace {

using Json = JsonObject::Json;

std::string shown(const Json& value) {
  if (value.is_array()) return "an array";
  if (value.is_object()) return "an object";
  return superstep::in_quotes(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void require_version(const std::string& file, const Json& json, const std::string& schema, int version) {
  const auto found = json.find("schema_version");
  if (found != json.end() && *found == version) return;
  const bool is_newer = found != json.end() && found->is_number() && *found > version;
  throw InputError(fmt::format("{}: schema_version is {}, and only version {} of '{}' is read here; {}", file,
                               found == json.end()  ? "missing"
                               : found->is_number() ? found->dump()
                                                    : shown(*found),
                               version, schema,
                               is_newer ? "it is newer: update superstep" : "write the file anew"));
}

}  // namespace

JsonObject::JsonObject(std::string file, const Json& json, std::string path)
    : file_(std::move(file)), path_(std::move(path)), json_(&json) {
  if (!json.is_object())
    throw InputError(fmt::format("{}: {} is {}; it must be an object; write the file anew", file_,
                                 path_.empty() ? "the root" : "key '" + path_ + "'", shown(json)));
}

std::string JsonObject::path_of(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

void JsonObject::reject(const std::string& key, const std::string& rule) const {
  const Json* value = find(key);
  throw InputError(fmt::format("{}: key '{}' is {}; {}; write the file anew", file_, path_of(key),
                               value ? shown(*value) : "missing", rule));
}

const Json* JsonObject::find(const std::string& key) const {
  const auto found = json_->find(key);
  return found == json_->end() || found->is_null() ? nullptr : &*found;
}

std::string JsonObject::text(const std::string& key) const {
  const Json* value = find(key);
  if (!value) return {};
  if (!value->is_string()) reject(key, "it must be a string");
  return value->get<std::string>();
}

std::optional<double> JsonObject::number(const std::string& key) const {
  const Json* value = find(key);
  if (!value) return std::nullopt;
  if (!value->is_number() || !std::isfinite(value->get<double>())) reject(key, "it must be a finite number");
  return value->get<double>();
}

bool JsonObject::flag(const std::string& key) const {
  const Json* value = find(key);
  if (!value) return false;
  if (!value->is_boolean()) reject(key, "it must be true or false");
  return value->get<bool>();
}

std::optional<std::uint64_t> JsonObject::count_up_to(const std::string& key, std::uint64_t most) const {
  const Json* value = find(key);
  if (!value) return std::nullopt;
  if (!value->is_number_unsigned() || value->get<std::uint64_t>() > most)
    reject(key, fmt::format("it must be an integer from 0 to {}", most));
  return value->get<std::uint64_t>();
}

const Json* JsonObject::array(const std::string& key) const {
  const Json* value = find(key);
  if (value && !value->is_array()) reject(key, "it must be an array");
  return value;
}

std::vector<double> JsonObject::numbers(const std::string& key) const {
  std::vector<double> out;
  const Json* values = array(key);
  if (!values) return out;
  for (const auto& value : *values) {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      reject(key, fmt::format("its entries must be finite numbers, and one is {}", shown(value)));
    out.push_back(value.get<double>());
  }
  return out;
}

std::vector<std::string> JsonObject::texts(const std::string& key) const {
  std::vector<std::string> out;
  const Json* values = array(key);
  if (!values) return out;
  for (const auto& value : *values) {
    if (!value.is_string())
      reject(key, fmt::format("its entries must be strings, and one is {}", shown(value)));
    out.push_back(value.get<std::string>());
  }
  return out;
}

void JsonObject::require_not_negative(const std::string& key) const {
  const Json* value = find(key);
  if (!value) return;
  const auto negative = [](const Json& one) { return one.is_number() && one.get<double>() < 0; };
  if (negative(*value)) reject(key, "it must not be negative");
  if (!value->is_array()) return;
  for (const auto& one : *value)
    if (negative(one))
      reject(key, fmt::format("its entries must not be negative, and one is {}", shown(one)));
}

void JsonObject::require_one_of(const std::string& key, const std::vector<std::string>& known) const {
  const std::string found = text(key);
  if (std::find(known.begin(), known.end(), found) == known.end())
    reject(key, fmt::format("it must be one of {}", fmt::join(known, ", ")));
}

std::optional<JsonObject> JsonObject::object(const std::string& key) const {
  const Json* value = find(key);
  return value ? std::optional<JsonObject>(std::in_place, file_, *value, path_of(key)) : std::nullopt;
}

std::vector<JsonObject> JsonObject::objects(const std::string& key) const {
  std::vector<JsonObject> out;
  if (const Json* values = array(key))
    for (std::size_t k = 0; k < values->size(); ++k)
      out.emplace_back(file_, (*values)[k], fmt::format("{}[{}]", path_of(key), k));
  return out;
}

Json parse_json_file(const std::string& file) {
  constexpr int deepest = 64;
  const auto not_too_deep = [&](int depth, Json::parse_event_t, const Json&) {
    if (depth > deepest)
      throw InputError(fmt::format("{}: it is nested deeper than {} levels; write it anew", file, deepest));
    return true;
  };
  Json json = Json::parse(read_text_file(file), not_too_deep, /*allow_exceptions=*/false);
  if (json.is_discarded()) throw InputError(fmt::format("{}: it is not JSON; write it anew", file));
  return json;
}

Json parse_results(const std::string& file, const std::string& schema, int version) {
  Json json = parse_json_file(file);
  if (!json.is_object() || JsonObject(file, json).text("schema") != schema)
    throw InputError(fmt::format("{}: its schema is not '{}'; give the folder of a result", file, schema));
  require_version(file, json, schema, version);
  return json;
}

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string csv_cell_of_json(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return csv_cell(value.get_ref<const std::string&>());
  if (value.is_number_float()) return csv_cell(value.get<double>());
  return value.dump();
}

}  // namespace superstep
