#pragma once
/// Rows of a sparse matrix as vector units like them: SELL-8.
///
///   Eight rows make a slice, stored entry by entry and padded to its longest row:
///     e0: r0 r1 ... r7 | e1: r0 r1 ... r7 | ...
///   Padding has value 0 and points at its own row, so that a difference y_j - y_i in it is 0 whatever y is.
/// Source of the layout: Kreutzer, Hager, Wellein, Fehske & Bishop (2014), doi:10.1137/130930352. The sorting
/// by length that keeps padding small is part of the node order: see `group_by_length`.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/aligned_array.hpp"
#include "core/parallel.hpp"

namespace superstep {

class SlicedRows {
 public:
  static constexpr std::size_t lanes = 8;

  SlicedRows() = default;
  /// Takes a pattern of compressed rows [rows+1], [nnz]; there are no values until `set_values`.
  SlicedRows(std::span<const std::int64_t> row_begin, std::span<const std::int32_t> column)
      : SlicedRows(row_begin, column, row_begin) {}
  /// The same of columns that stand elsewhere: those of a row from `first_column[row]` on.
  SlicedRows(std::span<const std::int64_t> row_begin, std::span<const std::int32_t> column,
             std::span<const std::int64_t> first_column);

  /// value_of(row, k) for entry k of the compressed pattern that the rows were built from.
  template <class ValueOf>
  void set_values(std::span<const std::int64_t> row_begin, const ValueOf& value_of);

  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  /// Slices, the last one perhaps with fewer than eight rows (its missing ones are padding).
  [[nodiscard]] std::size_t slices() const noexcept { return begin_.size() - 1; }
  /// Stored entries, padding included.
  [[nodiscard]] std::size_t entries() const noexcept { return static_cast<std::size_t>(begin_.back()); }
  /// The largest distance from a row to a later neighbour.
  [[nodiscard]] std::size_t reach() const noexcept { return reach_; }
  [[nodiscard]] const std::int64_t* begin() const noexcept { return begin_.data(); }  ///< [slices+1]
  [[nodiscard]] const std::int32_t* column() const noexcept { return column_.get(); }
  [[nodiscard]] const double* value() const noexcept { return value_.get(); }
  /// Calls each(column, value) for the entries of a row that have a value.
  template <class Each>
  void for_row(std::size_t row, const Each& each) const {
    const auto longest = static_cast<std::size_t>(begin_[row / lanes + 1] - begin_[row / lanes]) / lanes;
    for (std::size_t entry = 0; entry < longest; ++entry)
      if (const double value = value_[place(row, entry)]; value != 0) each(column_[place(row, entry)], value);
  }

 private:
  [[nodiscard]] std::size_t place(std::size_t row, std::size_t entry) const noexcept {
    return static_cast<std::size_t>(begin_[row / lanes]) + entry * lanes + row % lanes;
  }

  std::size_t rows_ = 0, reach_ = 0;
  bool has_values_ = false;
  std::vector<std::int64_t> begin_{0};
  // Left untouched by their allocation: the thread that will sweep over a part is the first to write it.
  AlignedArray<std::int32_t> column_;
  AlignedArray<double> value_;
};

/// Calls body(first, last) for ranges that cover all slices, each thread always the same one.
template <class Body>
void for_slices(const SlicedRows& rows, const Body& body) {
  for_ranges(rows.slices(), rows.rows(), body);
}

template <class ValueOf>
void SlicedRows::set_values(std::span<const std::int64_t> row_begin, const ValueOf& value_of) {
  for_slices(*this, [&](std::size_t first, std::size_t last) {
    if (!has_values_) std::fill(value_.get() + begin_[first], value_.get() + begin_[last], 0.0);  // padding
    for (std::size_t row = first * lanes; row < std::min(last * lanes, rows_); ++row) {
      const auto begin = static_cast<std::size_t>(row_begin[row]);
      for (std::size_t k = begin; k < static_cast<std::size_t>(row_begin[row + 1]); ++k)
        value_[place(row, k - begin)] = value_of(row, k);
    }
  });
  has_values_ = true;
}

}  // namespace superstep
