#pragma once
/// Passes that make a vector of a Krylov space orthogonal to others, for every instruction set.

#include <cstddef>
#include <span>

namespace superstep {

/// Kernels of one instruction set, over entries [first, last). Vectors do not overlap, but for `with`, which
/// may be the vector that is written. Sums run in eight lanes, so that AVX2 and AVX-512 agree bit by bit.
struct ArnoldiKernel {
  const char* name;
  /// w += diagonal * v; returns the sum of w * with.
  double (*add_diagonal)(double* w, const double* diagonal, const double* v, const double* with,
                         std::size_t first, std::size_t last);
  /// w -= part * v; returns the sum of w * with.
  double (*subtract)(double* w, double part, const double* v, const double* with, std::size_t first,
                     std::size_t last);
};

/// Those that this machine can run, the one in use first.
[[nodiscard]] std::span<const ArnoldiKernel> arnoldi_kernels() noexcept;

}  // namespace superstep
