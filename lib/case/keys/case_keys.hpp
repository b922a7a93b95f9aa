#pragma once
/// Every key of a case file, said once: `superstep list --keys` prints it, the table of the documentation is
/// made from it, and the tests hold it against what the readers ask for.

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace superstep {

/// One key.
struct CaseKey {
  /// What a value may be; several where the reader takes several.
  enum Type : unsigned { number = 1, integer = 2, boolean = 4, text = 8, array = 16, table = 32 };
  /// Cases that have the key: particles that do not move, a network given directly, particles that move.
  enum Scene : unsigned { packing = 1, network = 2, press = 4 };

  /// Where it stands: `thermal.fixed[].value`, `[]` standing for every element of an array.
  std::string place;
  unsigned scenes = 0;
  unsigned types = 0;
  unsigned elements = 0;  ///< types of the elements of an array
  std::size_t count = 0;  ///< elements that an array must have; 0 = any number
  /// Range of a number, and of the numbers in an array.
  double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
  bool min_open = false, max_open = false;
  std::vector<std::string> words{};  ///< that a text may be; empty = any
  bool may_be_empty = false;         ///< a text or an array
  std::string unit{}, fallback{}, meaning{};

  /// Last part of the place: "value".
  [[nodiscard]] std::string name() const;
  /// "number or table", "array of 3 numbers".
  [[nodiscard]] std::string type_text() const;
  /// "0 < value <= 1", "series | pipe"; empty = anything of its type.
  [[nodiscard]] std::string range_text() const;
  [[nodiscard]] std::vector<std::string> scene_names() const;
};

/// All keys, in the order in which one writes a case.
[[nodiscard]] std::span<const CaseKey> case_keys();

}  // namespace superstep
