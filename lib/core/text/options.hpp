#pragma once
/// Integrator SPECs `name:key=value,key=value` and their strict, typed keys.

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace superstep {

/// A SPEC split into its parts, not yet checked against any integrator.
struct Spec {
  std::string text;  ///< as the user wrote it
  std::string name;
  std::vector<std::pair<std::string, std::string>> settings;

  /// The part after the colon, empty when there is none.
  [[nodiscard]] std::string parameters() const;
};

/// Throws UsageError for an empty name, an empty key or value, a key without '=', or a key given twice.
[[nodiscard]] Spec parse_spec(const std::string& text);

/// The first of some SPECs that says what an earlier one says, in whatever order of its settings; empty =
/// none.
[[nodiscard]] std::string repeated_spec(std::span<const std::string> specs);

/// One key of a SPEC: what it means and which values it takes.
struct OptionKey {
  enum class Type { number, integer, word };
  std::string name{};
  Type type = Type::number;
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_open = false, max_open = false;  ///< the end itself is not allowed
  std::vector<std::string> words{};         ///< words that the key takes (a word key takes only these)
  std::string unit{};                       ///< "" = dimensionless
  std::string fallback{};                   ///< default as shown to the user
  std::string meaning{};

  /// "0 < nu < 1", "n >= 1", "recurrence | leja | natural".
  [[nodiscard]] std::string range() const;
};

/// The checked settings of one SPEC.
class Options {
 public:
  /// Checks every setting against `keys`. Throws UsageError with name, value, range and the nearest valid
  /// name.
  Options(Spec spec, std::span<const OptionKey> keys);

  /// Whether the user gave the key.
  [[nodiscard]] bool has(const std::string& key) const;
  /// Value of a key: the user's, else the default of the table. Throws std::logic_error where that is none.
  [[nodiscard]] double number(const std::string& key) const;
  [[nodiscard]] int integer(const std::string& key) const;
  [[nodiscard]] const std::string& word(const std::string& key) const;
  /// Number that the user gave; empty when the key was left out or given as a word.
  [[nodiscard]] std::optional<double> given(const std::string& key) const;
  /// Throws UsageError when more than one of `keys` is given.
  void at_most_one_of(std::span<const std::string> keys) const;
  [[nodiscard]] const Spec& spec() const noexcept { return spec_; }

 private:
  [[nodiscard]] const std::string* find(const std::string& key) const;
  Spec spec_;
  std::vector<std::pair<std::string, std::string>> defaults_;
};

}  // namespace superstep
