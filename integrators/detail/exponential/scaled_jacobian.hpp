#pragma once
/// The Jacobian at one state, assembled once and multiplied often.

#include <span>
#include <vector>

#include "core/state_vector.hpp"
#include "integrators/detail/error_norm.hpp"
#include "rhs/kernels/sliced_rows.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

/// S = D J D^-1, in whose coordinates D y lengths are capacity-weighted rms in units of the allowed error and
/// conduction is symmetric. It is kept as differences to neighbours and a diagonal, for the kernel of the
/// sweep.
class ScaledJacobian {
 public:
  void prepare(Rhs& rhs, const Task& task);
  /// Takes the Jacobian at (t, y); a constant one only once.
  void set(double t, std::span<const double> y);

  /// out = S v, and the sum over all entries of out times `other`.
  double multiply(const double* v, const double* other, double* out);

  [[nodiscard]] std::span<const double> scale() const noexcept { return scale_; }      ///< D
  [[nodiscard]] std::span<const double> inverse() const noexcept { return inverse_; }  ///< D^-1

 private:
  Rhs* rhs_ = nullptr;
  StateVector scale_, inverse_, diagonal_;
  std::vector<double> value_;  ///< [nnz] of the Rhs' pattern
  std::vector<std::int64_t> row_begin_;
  std::vector<std::int32_t> column_;    ///< [entries beside the diagonal], row by row
  std::vector<std::int64_t> position_;  ///< of them in value_
  SlicedRows rows_;
  bool is_set_ = false;
};

}  // namespace superstep
