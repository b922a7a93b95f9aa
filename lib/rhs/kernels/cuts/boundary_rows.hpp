#pragma once
/// Rows of a shared network that need values of other processes.
///
///   Rows are swept in slices of eight. A slice none of whose rows needs the halo is swept over the state as
///   it is, while the halo travels. The others are swept over a compact copy of what they need, in the same
///   order of terms:
///     [ own rows of the boundary's slices | other own rows | halo ]
///   so that a row has the same bits whoever owns its neighbours.

#include <algorithm>
#include <vector>

#include "core/index.hpp"
#include "network/network.hpp"
#include "rhs/kernels/sliced_rows.hpp"
#include "rhs/stage.hpp"

namespace superstep {

class BoundaryRows {
 public:
  /// Of a network with a halo.
  explicit BoundaryRows(const Network& network);

  /// Compressed rows without those of the boundary's slices, which are empty here.
  [[nodiscard]] SlicedRows interior_rows(const Network& network) const;
  /// Where those rows begin [rows+1].
  [[nodiscard]] std::span<const std::int64_t> interior_begin() const noexcept { return interior_begin_; }
  /// value_of(row, k) for entry k of the network's rows.
  template <class ValueOf>
  void set_values(const Network& network, const ValueOf& value_of);

  /// Gives back the memory that only new values would need.
  void forget_pattern() noexcept {
    std::vector<std::int64_t>().swap(interior_begin_);
    std::vector<std::int64_t>().swap(row_begin_);
  }
  /// Calls each(row, column, value) for the entries of the boundary's own rows; columns from `rows` on are of
  /// the halo.
  template <class Each>
  void for_entries(std::size_t rows, const Each& each) const;

  /// The halo sets out, and what is here already is copied. Between the two calls y stays as it is.
  void begin(const double* y);
  void end() { halo_->end(); }

  /// Calls body(first, last) for stretches of slices [first, last) that are not of the boundary.
  template <class Body>
  void for_interior(std::size_t first, std::size_t last, const Body& body) const;
  /// Slices of the boundary, and where each of them stands among all.
  [[nodiscard]] std::size_t slices() const noexcept { return slice_.size(); }
  [[nodiscard]] std::size_t entries() const noexcept { return rows_.entries(); }
  [[nodiscard]] std::size_t slice(std::size_t k) const noexcept { return slice_[k]; }
  /// One stage on the boundary's slice number k. The state that it starts from is the copied one.
  void sweep(const Stage& stage, std::size_t k, double* out) const noexcept;

 private:
  static constexpr std::size_t lanes = SlicedRows::lanes;

  std::shared_ptr<Halo> halo_;
  std::vector<std::size_t> slice_;            ///< ascending
  std::vector<std::int64_t> interior_begin_;  ///< [rows+1]
  std::vector<std::int64_t> row_begin_;       ///< of the boundary's rows
  std::vector<std::int32_t> source_;          ///< [own part of the copy] row of the state
  SlicedRows rows_;
  std::vector<double> value_;  ///< the copy, halo last
};

template <class Body>
void BoundaryRows::for_interior(std::size_t first, std::size_t last, const Body& body) const {
  auto next = std::lower_bound(slice_.begin(), slice_.end(), first);
  while (first < last) {
    const std::size_t end = next == slice_.end() ? last : std::min(last, *next);
    if (first < end) body(first, end);
    if (end == last) return;
    first = end + 1;
    ++next;
  }
}

template <class Each>
void BoundaryRows::for_entries(std::size_t rows, const Each& each) const {
  for (std::size_t k = 0; k < slice_.size() * lanes; ++k) {
    const std::size_t own = slice_[k / lanes] * lanes + k % lanes;
    if (own >= rows) return;
    rows_.for_row(k, [&](std::int32_t place, double value) {
      const auto copied = static_cast<std::size_t>(place);
      each(own, copied < source_.size() ? at(source_[copied]) : rows + (copied - source_.size()), value);
    });
  }
}

template <class ValueOf>
void BoundaryRows::set_values(const Network& network, const ValueOf& value_of) {
  rows_.set_values(row_begin_, [&](std::size_t row, std::size_t k) {
    const std::size_t own = slice_[row / lanes] * lanes + row % lanes;
    const auto begin = static_cast<std::size_t>(network.row_begin[own]);
    return value_of(own, begin + (k - static_cast<std::size_t>(row_begin_[row])));
  });
}

}  // namespace superstep
