#pragma once
/// Jacobian values from a list of contributions, several of which may meet in one place.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rhs/kernels/sparse_pattern.hpp"

namespace superstep {

/// Contributions come in the same order at every evaluation; the k-th one goes to the same place each time.
class JacobianAssembly {
 public:
  /// Pattern that holds every place that `enumerate(add)` names with add(row, column, value), and the
  /// diagonal.
  ///   n  number of rows and columns
  template <class Enumerate>
  [[nodiscard]] SparsePattern build(std::size_t n, Enumerate enumerate);
  /// values [nnz] = sum of the contributions in each place.
  template <class Enumerate>
  void fill(std::span<double> values, Enumerate enumerate) const;

 private:
  using Place = std::pair<std::int64_t, std::int64_t>;  ///< column, row
  [[nodiscard]] SparsePattern build_from(std::size_t n, const std::vector<Place>& places);

  std::vector<std::int64_t> position_;  ///< [contributions] index into the values
};

template <class Enumerate>
SparsePattern JacobianAssembly::build(std::size_t n, Enumerate enumerate) {
  std::vector<Place> places;
  enumerate([&](std::size_t row, std::size_t column, double) {
    places.emplace_back(static_cast<std::int64_t>(column), static_cast<std::int64_t>(row));
  });
  return build_from(n, places);
}

template <class Enumerate>
void JacobianAssembly::fill(std::span<double> values, Enumerate enumerate) const {
  for (double& value : values) value = 0;
  std::size_t k = 0;
  enumerate([&](std::size_t, std::size_t, double value) {
    values[static_cast<std::size_t>(position_[k++])] += value;
  });
}

}  // namespace superstep
