#pragma once
/// Passes of the Lanczos recurrence over some entries of its vectors, for every instruction set.

#include <cstddef>
#include <span>

namespace superstep {

/// Vectors that a pass of the recurrence reads and writes; none overlaps another.
struct LanczosPass {
  double* next = nullptr;       ///< w, becomes v_{j+1}
  const double* now = nullptr;  ///< v_j
  const double* capacity = nullptr;
};

/// Kernels of one instruction set; Kept is the precision of the basis. Sums run in eight lanes, so that AVX2
/// and AVX-512 agree bit by bit.
template <class Kept>
struct LanczosKernel {
  const char* name;
  /// Keeps unit * now in `kept`; returns the sum of capacity * next * now.
  double (*keep_and_project)(const LanczosPass& pass, double unit, Kept* kept, std::size_t first,
                             std::size_t last);
  /// next -= part * now; returns the sum of capacity * next^2.
  double (*subtract)(const LanczosPass& pass, double part, std::size_t first, std::size_t last);
  /// sum += factor[0] vector[0] + ... + factor[3] vector[3].
  void (*add_four)(const Kept* const* vector, const double* factor, double* sum, std::size_t first,
                   std::size_t last);
};

/// Those that this machine can run, the one in use first. Kept: float or double.
template <class Kept>
[[nodiscard]] std::span<const LanczosKernel<Kept>> lanczos_kernels() noexcept;

}  // namespace superstep
