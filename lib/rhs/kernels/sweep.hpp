#pragma once
/// The sweep over the network, fused with the update of a three-term stage.
///
/// One kernel on SELL-8 rows, compiled for several instruction sets and chosen at run time, and one obvious
/// kernel on compressed rows that it is tested against. Every kernel adds up a row in the same order;
/// instruction sets with fused multiply-add round a product and its sum once instead of twice, so that
/// results agree to rounding between x86-64 and the others, and bit by bit between AVX2 and AVX-512. Threads
/// change nothing.

#include <cstdint>
#include <span>

#include "rhs/kernels/sliced_rows.hpp"
#include "rhs/stage.hpp"

namespace superstep {

/// The kernels of one instruction set. They work on whole slices [first, last).
struct SweepKernel {
  using Sweep = void (*)(const SlicedRows& rate, const Stage& stage, std::size_t first, std::size_t last,
                         double* out) noexcept;
  using Heat = void (*)(const SlicedRows& weight, const double* potential, const double* inverse_capacity,
                        std::size_t first, std::size_t last, double* out) noexcept;
  const char* name;
  Sweep sweep;
  Heat heat;
};

/// Those that this machine can run, the one in use first.
[[nodiscard]] std::span<const SweepKernel> sweep_kernels() noexcept;

/// out = a*y1 + b*y2 + c*y0 + d*sum_j rate_ij (y1_j - y1_i) + e*f0 for all rows, rate_ij = K_ij/C_i [1/s].
/// Differences, not row sums: a uniform state stays exactly as it is.
void fused_sweep(const SlicedRows& rate, const Stage& stage, double* out) noexcept;
/// The same for the rows of slices [first, last), on this thread.
void fused_sweep(const SlicedRows& rate, const Stage& stage, std::size_t first, std::size_t last,
                 double* out) noexcept;

/// out_i = sum_j weight_ij (V_j - V_i)^2 / C_i for all rows: Joule heat [K/s].
void heat_sweep(const SlicedRows& weight, const double* potential, const double* inverse_capacity,
                double* out) noexcept;

/// Compressed rows of the scaled network: rate[k] = K_ij / C_i [1/s].
struct SweepRows {
  std::span<const std::int64_t> row_begin;
  std::span<const std::int32_t> column;
  std::span<const double> rate;
};

/// What `fused_sweep` must compute: slow and obvious.
void reference_sweep(const SweepRows& rows, const Stage& stage, double* out) noexcept;

}  // namespace superstep
