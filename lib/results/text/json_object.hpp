#pragma once
/// Results read back from JSON: a value of another type than it was written with is the file's fault, and the
/// error names the file and the key.

#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace superstep {

/// Values of one object by key; null and missing are empty. Refers to the JSON that it is made from.
class JsonObject {
 public:
  using Json = nlohmann::ordered_json;

  /// `path` of the object in its file, e.g. "cases[0].rows[2]"; empty at the root. Throws InputError when it
  /// is no object.
  JsonObject(std::string file, const Json& json, std::string path = {});

  /// The value, or nullptr when it is null or missing.
  [[nodiscard]] const Json* find(const std::string& key) const;
  [[nodiscard]] std::string text(const std::string& key) const;  ///< empty when missing
  [[nodiscard]] std::optional<double> number(const std::string& key) const;
  [[nodiscard]] double number_or_zero(const std::string& key) const { return number(key).value_or(0); }
  [[nodiscard]] bool flag(const std::string& key) const;  ///< false when missing
  /// A count >= 0.
  template <class Integer>
  [[nodiscard]] std::optional<Integer> count(const std::string& key) const {
    const auto value = count_up_to(key, static_cast<std::uint64_t>(std::numeric_limits<Integer>::max()));
    return value ? std::optional<Integer>(static_cast<Integer>(*value)) : std::nullopt;
  }
  [[nodiscard]] std::vector<double> numbers(const std::string& key) const;
  [[nodiscard]] std::vector<std::string> texts(const std::string& key) const;
  [[nodiscard]] std::optional<JsonObject> object(const std::string& key) const;
  [[nodiscard]] std::vector<JsonObject> objects(const std::string& key) const;

  /// Refuses a number below 0, in an array too. What is no number is left to its reader.
  void require_not_negative(const std::string& key) const;
  /// Refuses any other text, and none.
  void require_one_of(const std::string& key, const std::vector<std::string>& known) const;

  [[nodiscard]] const Json& json() const noexcept { return *json_; }
  /// Throws InputError "file: key 'path.key' is value; rule; write the file anew".
  [[noreturn]] void reject(const std::string& key, const std::string& rule) const;

 private:
  [[nodiscard]] std::optional<std::uint64_t> count_up_to(const std::string& key, std::uint64_t most) const;
  [[nodiscard]] const Json* array(const std::string& key) const;
  [[nodiscard]] std::string path_of(const std::string& key) const;

  std::string file_, path_;
  const Json* json_;
};

/// Text of a JSON file. What users wrote and is quoted need not be UTF-8: what is not is replaced.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

/// One value as a CSV cell; null is empty.
[[nodiscard]] std::string csv_cell_of_json(const nlohmann::ordered_json& value);

/// Throws InputError for what is not JSON, or nested deeper than anything that is written here: what walks
/// through such a value goes as deep into the stack.
[[nodiscard]] nlohmann::ordered_json parse_json_file(const std::string& file);

/// Parses a results file. Throws InputError unless it is an object with this "schema" and this
/// "schema_version": another one has keys that mean something else.
[[nodiscard]] nlohmann::ordered_json parse_results(const std::string& file, const std::string& schema,
                                                   int version);

}  // namespace superstep
