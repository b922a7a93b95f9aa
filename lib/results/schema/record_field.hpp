#pragma once
/// What a file of results holds, stated once: every record has one list of its fields, with name, unit,
/// meaning and how each is written and read. CSV columns, JSON, its reader and its JSON Schema come from it.

#include <cmath>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "results/results.hpp"
#include "results/text/json_object.hpp"

namespace superstep {

using Json = nlohmann::ordered_json;

template <class Record>
struct RecordField {
  std::string name;
  std::string meaning;  ///< with its unit, for people
  Json schema;          ///< JSON Schema of its value
  std::function<Json(const Record&)> write;
  std::function<void(Record&, const JsonObject&)> read;  ///< empty: follows from other fields
  bool always = true;                                    ///< false: left out where it is null
};

template <class Record>
using RecordFields = std::vector<RecordField<Record>>;

/// The fields of a record that others contain; one specialization for each.
template <class Record>
[[nodiscard]] const RecordFields<Record>& fields_of();

template <class Record>
[[nodiscard]] Json write_record(const RecordFields<Record>& fields, const Record& record) {
  Json out = Json::object();
  for (const auto& field : fields)
    if (Json value = field.write(record); field.always || !value.is_null())
      out[field.name] = std::move(value);
  return out;
}

template <class Record>
void read_record(const RecordFields<Record>& fields, Record& record, const JsonObject& json) {
  for (const auto& field : fields)
    if (field.read) field.read(record, json);
}

/// JSON Schema of an object with these fields; others may follow in later versions.
template <class Record>
[[nodiscard]] Json record_schema(const RecordFields<Record>& fields) {
  Json properties = Json::object(), required = Json::array();
  for (const auto& field : fields) {
    Json property = field.schema;
    if (!field.meaning.empty()) property["description"] = field.meaning;
    properties[field.name] = std::move(property);
    if (field.always) required.push_back(field.name);
  }
  return {{"type", "object"}, {"properties", properties}, {"required", required}};
}

// How values of each type look in JSON. Numbers that are not finite, and what was not measured, are null.
namespace json_value {

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};

template <class T>
Json schema() {
  if constexpr (std::is_same_v<T, std::string>) {
    return {{"type", "string"}};
  } else if constexpr (std::is_same_v<T, bool>) {
    return {{"type", "boolean"}};
  } else if constexpr (std::is_integral_v<T>) {
    return {{"type", "integer"}, {"minimum", 0}};
  } else if constexpr (std::is_same_v<T, double>) {
    return {{"type", Json::array({"number", "null"})}};
  } else if constexpr (std::is_same_v<T, std::vector<Fact>>) {
    return {{"type", "object"}, {"additionalProperties", {{"type", "string"}}}};
  } else if constexpr (IsVector<T>::value) {
    return {{"type", "array"}, {"items", schema<typename T::value_type>()}};
  } else if constexpr (IsOptional<T>::value) {
    Json of_value = schema<typename T::value_type>();
    if (!of_value["type"].is_array()) of_value["type"] = Json::array({of_value["type"], "null"});
    return of_value;
  } else {
    return record_schema(fields_of<T>());
  }
}

template <class T>
Json write(const T& value) {
  if constexpr (std::is_same_v<T, double>) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
  } else if constexpr (std::is_same_v<T, std::string> || std::is_same_v<T, bool>) {
    return value;
  } else if constexpr (std::is_integral_v<T>) {
    return static_cast<std::uint64_t>(value);
  } else if constexpr (std::is_same_v<T, std::vector<Fact>>) {
    Json out = Json::object();
    for (const auto& fact : value) out[fact.name] = fact.value;
    return out;
  } else if constexpr (IsVector<T>::value) {
    Json out = Json::array();
    for (const auto& one : value) out.push_back(write(one));
    return out;
  } else if constexpr (IsOptional<T>::value) {
    return value ? write(*value) : Json(nullptr);
  } else {
    return write_record(fields_of<T>(), value);
  }
}

template <class T>
void read(T& value, const JsonObject& json, const std::string& key) {
  if constexpr (std::is_same_v<T, std::string>) {
    value = json.text(key);
  } else if constexpr (std::is_same_v<T, bool>) {
    value = json.flag(key);
  } else if constexpr (std::is_integral_v<T>) {
    value = json.count<T>(key).value_or(0);
  } else if constexpr (std::is_same_v<T, double>) {
    value = json.number_or_zero(key);
  } else if constexpr (std::is_same_v<T, std::vector<double>>) {
    value = json.numbers(key);
  } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
    value = json.texts(key);
  } else if constexpr (std::is_same_v<T, std::vector<Fact>>) {
    value.clear();
    if (const auto facts = json.object(key))
      for (const auto& [name, ignored] : facts->json().items()) value.push_back({name, facts->text(name)});
  } else if constexpr (IsVector<T>::value) {
    value.clear();
    for (const auto& one : json.objects(key))
      read_record(fields_of<typename T::value_type>(), value.emplace_back(), one);
  } else if constexpr (IsOptional<T>::value) {
    using Inner = typename T::value_type;
    value.reset();
    if constexpr (std::is_same_v<Inner, double>) {
      value = json.number(key);
    } else if constexpr (std::is_integral_v<Inner>) {
      value = json.count<Inner>(key);
    } else if (const auto object = json.object(key)) {
      read_record(fields_of<Inner>(), value.emplace(), *object);
    }
  } else {
    if (const auto object = json.object(key)) read_record(fields_of<T>(), value, *object);
  }
}

}  // namespace json_value

/// A field that is a member of its record.
template <class Record, class Value>
[[nodiscard]] RecordField<Record> field(std::string name, Value Record::*member, std::string meaning = {}) {
  return {name, std::move(meaning), json_value::schema<Value>(),
          [member](const Record& record) { return json_value::write(record.*member); },
          [member, name](Record& record, const JsonObject& json) {
            json_value::read(record.*member, json, name);
          }};
}

/// The same of a number, or of numbers, of which none is negative: a file that has one was not measured.
template <class Record, class Value>
[[nodiscard]] RecordField<Record> amount(std::string name, Value Record::*member, std::string meaning = {}) {
  auto out = field(std::move(name), member, std::move(meaning));
  Json& number = out.schema.contains("items") ? out.schema["items"] : out.schema;
  number["minimum"] = 0;
  out.read = [name = out.name, read = std::move(out.read)](Record& record, const JsonObject& json) {
    json.require_not_negative(name);
    read(record, json);
  };
  return out;
}

/// A text that is one of `known`.
template <class Record>
[[nodiscard]] RecordField<Record> one_of(RecordField<Record> one, std::vector<std::string> known) {
  one.schema["enum"] = known;
  one.read = [name = one.name, read = std::move(one.read), known = std::move(known)](Record& record,
                                                                                     const JsonObject& json) {
    json.require_one_of(name, known);
    read(record, json);
  };
  return one;
}

/// A field that follows from others: written, not read.
///   Value  the type of what `of` gives
template <class Record, class Function>
[[nodiscard]] RecordField<Record> derived(std::string name, Function of, std::string meaning = {}) {
  using Value = std::decay_t<std::invoke_result_t<Function, const Record&>>;
  return {std::move(name),
          std::move(meaning),
          json_value::schema<Value>(),
          [of](const Record& record) { return json_value::write<Value>(of(record)); },
          {}};
}

/// An object that holds fields of the record itself.
template <class Record>
[[nodiscard]] RecordField<Record> group(std::string name, RecordFields<Record> fields,
                                        std::string meaning = {}) {
  return {name, std::move(meaning), record_schema(fields),
          [fields](const Record& record) { return write_record(fields, record); },
          [fields, name](Record& record, const JsonObject& json) {
            if (const auto object = json.object(name)) read_record(fields, record, *object);
          }};
}

/// Text of a file that holds one record: its schema and version first.
template <class Record>
[[nodiscard]] std::string json_file_text(const char* schema, int version, const Record& record) {
  Json out = {{"schema", schema}, {"schema_version", version}};
  out.update(write_record(fields_of<Record>(), record));
  return json_text(out);
}

}  // namespace superstep
