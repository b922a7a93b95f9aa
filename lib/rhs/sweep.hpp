#pragma once
/// The sweep over the network, fused with the update of a three-term stage.

#include <cstdint>
#include <span>

#include "rhs/rhs.hpp"

namespace superstep {

/// Rows of the scaled network: rate[k] = K_ij / C_i [1/s].
struct SweepRows {
  std::span<const std::int64_t> row_begin;
  std::span<const std::int32_t> column;
  std::span<const double> rate;
};

/// out = a*y1 + b*y2 + c*y0 + d*sum_j rate_ij (y1_j - y1_i) + e*f0 for all rows.
/// Differences, not row sums: a uniform state stays exactly as it is.
void fused_sweep(const SweepRows& rows, const Stage& stage, double* out) noexcept;

}  // namespace superstep
