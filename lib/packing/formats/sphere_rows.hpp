#pragma once
/// Rows of cells on their way into a packing: what every reader hands its rows to.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "packing/formats/columns/columns.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/packing_builder.hpp"

namespace superstep {

/// What a reader knows before the first row.
struct SphereLayout {
  std::vector<std::string> names = {};  ///< of the columns
  std::string place;                    ///< "file:line" of the names
  std::string header;                   ///< what they stand in, for messages, as in "'ITEM: ATOMS'"
  ColumnRules rules = {};
  std::optional<Cell> cell = {};        ///< in units of the file
  bool cell_binds = false;              ///< particles far outside it are an error
  std::optional<StatedUnit> unit = {};  ///< that the format states
  std::string row = "line";             ///< what a row is, for messages
};

class SphereRows {
 public:
  /// Throws InputError for columns that are missing and units that contradict each other.
  SphereRows(const PackingFile& file, SphereLayout layout);

  /// A row with as many cells as there are names. Throws InputError that names line, column and value.
  void add(std::span<const std::string_view> cells, std::size_t line);
  void add(std::span<const double> cells, std::size_t line);
  [[nodiscard]] std::size_t size() const noexcept { return builder_.size(); }
  /// The packing with its cell, attributes and notes. Throws InputError when it is empty, when ids or centres
  /// coincide, and when centres lie far outside a box that binds.
  [[nodiscard]] Packing finish();

 private:
  template <class Value>
  void add_row(std::span<const Value> cells, std::size_t line);
  template <class Value>
  [[nodiscard]] double number(std::span<const Value> cells, std::size_t column, std::size_t line) const;
  template <class Value>
  [[nodiscard]] std::int64_t id(std::span<const Value> cells, std::size_t line) const;
  template <class Value>
  [[nodiscard]] double radius(std::span<const Value> cells, std::size_t line) const;
  /// The position in units of the file, of these columns.
  template <class Value>
  [[nodiscard]] Vec3 point(std::span<const Value> cells, const SphereColumns::Axes& axes,
                           std::size_t line) const;
  template <class Value>
  void require_one_position(std::span<const Value> cells, Vec3 centre, double size, std::size_t line) const;
  /// What stands twice under one name must be the same.
  template <class Value>
  void require_same_again(std::span<const Value> cells, std::size_t line) const;
  template <class Value>
  void add_attributes(std::span<const Value> cells);
  void set_material(std::string_view name, std::size_t line);
  void note_columns(Packing& packing) const;
  [[nodiscard]] Cell cell_in_metres() const;

  SphereLayout layout_;
  std::string path_;
  SphereColumns columns_;
  Packing head_;  ///< notes and warnings about units
  double unit_;
  PackingBuilder builder_;
  std::vector<PackingAttribute> attributes_;
  std::vector<char> is_text_;  ///< [attributes]
};

}  // namespace superstep
