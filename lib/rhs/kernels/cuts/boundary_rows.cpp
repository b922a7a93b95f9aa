#include "rhs/kernels/cuts/boundary_rows.hpp"

#include "core/index.hpp"
#include "rhs/kernels/sweep.hpp"

namespace superstep {

BoundaryRows::BoundaryRows(const Network& network) : halo_(network.halo) {
  const std::size_t n = network.size();
  const auto beyond = [&](std::size_t row) {
    return std::any_of(network.column.begin() + network.row_begin[row],
                       network.column.begin() + network.row_begin[row + 1],
                       [&](std::int32_t column) { return at(column) >= n; });
  };
  interior_begin_.assign(n + 1, 0);
  std::vector<std::int32_t> place(n, -1);  // of own rows in the copy
  for (std::size_t first = 0; first < n; first += lanes) {
    const std::size_t last = std::min(first + lanes, n);
    bool of_boundary = false;
    for (std::size_t row = first; row < last; ++row) of_boundary = of_boundary || beyond(row);
    if (of_boundary) slice_.push_back(first / lanes);
    for (std::size_t row = first; row < last; ++row) {
      const auto length = of_boundary ? 0 : network.row_begin[row + 1] - network.row_begin[row];
      interior_begin_[row + 1] = interior_begin_[row] + length;
      if (!of_boundary) continue;
      place[row] = static_cast<std::int32_t>(source_.size());
      source_.push_back(static_cast<std::int32_t>(row));
    }
  }
  const std::size_t rows = source_.size();
  row_begin_.push_back(0);
  for (std::size_t k = 0; k < rows; ++k) {
    const auto row = at(source_[k]);
    for (auto e = network.row_begin[row]; e < network.row_begin[row + 1]; ++e) {
      const auto column = at(network.column[at(e)]);
      if (column >= n || place[column] >= 0) continue;
      place[column] = static_cast<std::int32_t>(source_.size());
      source_.push_back(static_cast<std::int32_t>(column));
    }
    row_begin_.push_back(row_begin_.back() + network.row_begin[row + 1] - network.row_begin[row]);
  }
  std::vector<std::int32_t> column;
  for (std::size_t k = 0; k < rows; ++k) {
    const auto row = at(source_[k]);
    for (auto e = network.row_begin[row]; e < network.row_begin[row + 1]; ++e) {
      const auto there = at(network.column[at(e)]);
      column.push_back(there < n ? place[there] : static_cast<std::int32_t>(source_.size() + (there - n)));
    }
  }
  rows_ = SlicedRows(row_begin_, column);
  value_.resize(source_.size() + halo_->size());
}

SlicedRows BoundaryRows::interior_rows(const Network& network) const {
  return {interior_begin_, network.column, network.row_begin};
}

void BoundaryRows::begin(const double* y) {
  halo_->begin(y, value_.data() + source_.size());
  for_each_entry(source_.size(), [&](std::size_t k) { value_[k] = y[source_[k]]; });
}

void BoundaryRows::sweep(const Stage& stage, std::size_t k, double* out) const noexcept {
  // The kernel takes slice k of the copy; what it reads and writes of the state stands elsewhere.
  const auto shift = (static_cast<std::ptrdiff_t>(slice_[k]) - static_cast<std::ptrdiff_t>(k)) *
                     static_cast<std::ptrdiff_t>(lanes);
  Stage here = stage;
  here.y1 = value_.data();
  if (here.y2) here.y2 += shift;
  if (here.y0) here.y0 += shift;
  if (here.f0) here.f0 += shift;
  fused_sweep(rows_, here, k, k + 1, out + shift);
}

}  // namespace superstep
