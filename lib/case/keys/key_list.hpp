#pragma once
/// Writing down keys: those of one table after the other, and the groups that stand in several tables.

#include "case/keys/case_keys.hpp"

namespace superstep {

/// Range of a number.
struct KeyRange {
  double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
  bool min_open = false, max_open = false;
};
inline constexpr KeyRange any_number{};
inline constexpr KeyRange positive_number{.min = 0, .min_open = true};
inline constexpr KeyRange no_less_than_zero{.min = 0};
inline constexpr KeyRange part{.min = 0, .max = 1};  // ends included
inline constexpr KeyRange proper_part{.min = 0, .max = 1, .max_open = true};

class KeyList {
 public:
  /// Keys that follow stand in this table ("" = the root) of these scenes.
  KeyList& in(std::string table, unsigned scenes);

  /// Each returns the key, for what else is to be said about it.
  CaseKey& number(const std::string& name, KeyRange range, std::string unit, std::string meaning);
  CaseKey& integer(const std::string& name, KeyRange range, std::string meaning);
  CaseKey& boolean(const std::string& name, std::string fallback, std::string meaning);
  CaseKey& text(const std::string& name, std::string meaning, std::vector<std::string> words = {});
  CaseKey& numbers(const std::string& name, std::size_t count, KeyRange range, std::string unit,
                   std::string meaning);
  CaseKey& list(const std::string& name, unsigned elements, std::string meaning);
  CaseKey& table(const std::string& name, std::string meaning);

  /// A number or a table of time.
  void amount(const std::string& name, const std::string& unit, const std::string& meaning,
              unsigned other_types = 0);
  /// Values at the start: a number or a column.
  void initial(const std::string& unit, const std::string& meaning, unsigned other_types = 0);
  /// A selection of particles.
  void where(const std::string& name);
  /// A number or a law of temperature.
  void conductivity(const std::string& unit);
  /// A layer between two particles.
  void boundary(const std::string& name, const std::string& otherwise = "none");

  [[nodiscard]] std::vector<CaseKey> take() { return std::move(keys_); }

 private:
  CaseKey& add(const std::string& name, unsigned types, std::string meaning);

  std::string table_;
  unsigned scenes_ = 0;
  std::vector<CaseKey> keys_;
};

/// The keys of each kind of case.
void list_common_keys(KeyList& keys);
void list_corpus_keys(KeyList& keys);
void list_packing_keys(KeyList& keys);
/// A table of sizes in the table at hand, its diameters in `unit`.
void list_sizes(KeyList& keys, const std::string& unit);
void list_field_keys(KeyList& keys);
void list_press_keys(KeyList& keys);

}  // namespace superstep
