#include "rhs/kernels/sliced_rows.hpp"

#include <algorithm>

namespace superstep {

SlicedRows::SlicedRows(std::span<const std::int64_t> row_begin, std::span<const std::int32_t> column,
                       std::span<const std::int64_t> first_column)
    : rows_(row_begin.size() - 1) {
  const std::size_t slices = (rows_ + lanes - 1) / lanes;
  begin_.resize(slices + 1);
  for (std::size_t slice = 0; slice < slices; ++slice) {
    std::int64_t longest = 0;
    for (std::size_t row = slice * lanes; row < std::min((slice + 1) * lanes, rows_); ++row)
      longest = std::max(longest, row_begin[row + 1] - row_begin[row]);
    begin_[slice + 1] = begin_[slice] + longest * static_cast<std::int64_t>(lanes);
  }
  for (std::size_t row = 0; row < rows_; ++row)
    for (std::int64_t k = 0; k < row_begin[row + 1] - row_begin[row]; ++k) {
      const auto neighbour =
          static_cast<std::size_t>(column[static_cast<std::size_t>(first_column[row] + k)]);
      if (neighbour > row) reach_ = std::max(reach_, neighbour - row);
    }
  column_ = aligned_array<std::int32_t>(entries());
  value_ = aligned_array<double>(entries());
  for_ranges(slices, rows_, [&](std::size_t first, std::size_t last) {
    for (std::size_t row = first * lanes; row < last * lanes; ++row) {
      const std::size_t own = std::min(row, rows_ - 1);
      const auto longest = static_cast<std::size_t>(begin_[row / lanes + 1] - begin_[row / lanes]) / lanes;
      const auto begin = static_cast<std::size_t>(row < rows_ ? first_column[row] : 0);
      const auto length = static_cast<std::size_t>(row < rows_ ? row_begin[row + 1] - row_begin[row] : 0);
      for (std::size_t entry = 0; entry < longest; ++entry)
        column_[place(row, entry)] = entry < length ? column[begin + entry] : static_cast<std::int32_t>(own);
    }
  });
}

}  // namespace superstep
