#pragma once
/// Sweeps whose conductances follow the state: formed on the way from one value a node, never stored.
///
/// With s = 1/kappa a harmonic mean costs one division a branch, 2 kappa_i kappa_j/(kappa_i + kappa_j) =
/// 2/(s_i + s_j); with s = kappa an arithmetic one none. A node's value and its s lie side by side, so that
/// a neighbour is one load. As in sweep.hpp, kernels add up a row in the same order, AVX2 and AVX-512 agree
/// bit by bit, and threads change nothing.

#include <cstdint>
#include <span>

#include "rhs/conductance_mean.hpp"
#include "rhs/kernels/sliced_rows.hpp"
#include "rhs/stage.hpp"

namespace superstep {

/// Value [K or V] and s of a node: 1/kappa of a harmonic mean, kappa of an arithmetic one.
struct NodePair {
  double value, s;
};

/// s of a conductivity.
[[nodiscard]] inline double node_factor(ConductanceMean mean, double conductivity) noexcept {
  return mean == ConductanceMean::harmonic ? 1 / conductivity : conductivity;
}
/// What a geometric factor is multiplied by to become an entry of the rows.
[[nodiscard]] inline double geometry_factor(ConductanceMean mean) noexcept {
  return mean == ConductanceMean::harmonic ? 2.0 : 0.5;
}

/// The kernels of one instruction set. They work on whole slices [first, last).
struct VaryingKernel {
  using Sweep = void (*)(const SlicedRows& geometry, const NodePair* nodes, const Stage& stage,
                         std::size_t first, std::size_t last, double* out) noexcept;
  using Heat = void (*)(const SlicedRows& geometry, const NodePair* nodes, const double* inverse_capacity,
                        std::size_t first, std::size_t last, double* out) noexcept;
  const char* name;
  Sweep harmonic_sweep, arithmetic_sweep;
  Heat harmonic_heat, arithmetic_heat;
  [[nodiscard]] Sweep sweep(ConductanceMean mean) const noexcept {
    return mean == ConductanceMean::harmonic ? harmonic_sweep : arithmetic_sweep;
  }
  [[nodiscard]] Heat heat(ConductanceMean mean) const noexcept {
    return mean == ConductanceMean::harmonic ? harmonic_heat : arithmetic_heat;
  }
};

/// Those that this machine can run, the one in use first.
[[nodiscard]] std::span<const VaryingKernel> varying_kernels() noexcept;

/// out = a*y1 + b*y2 + c*y0 + d*sum_j g_ij m(s_i, s_j) (y1_j - y1_i) + e*f0 for the rows of slices
/// [first, last), with y1 in `nodes` (stage.y1 is not read) and m = 1/(s_i + s_j) or s_i + s_j.
///   geometry  G_ij/C_i times geometry_factor;  nodes [rows]
void varying_sweep(ConductanceMean mean, const SlicedRows& geometry, const NodePair* nodes,
                   const Stage& stage, std::size_t first, std::size_t last, double* out) noexcept;

/// Joule heat of all rows [K/s]: out_i = sum_j G_ij heat(kappa_i, kappa_j) (V_j - V_i)^2 / C_i, see
/// conductance_mean.hpp.
///   geometry  G_ij times geometry_factor;  nodes [slots]  the rows first
void varying_heat(ConductanceMean mean, const SlicedRows& geometry, const NodePair* nodes,
                  const double* inverse_capacity, double* out) noexcept;

/// What `varying_sweep` must compute for all rows: slow and obvious.
///   geometry [nnz]  G_ij/C_i;  conductivity, y [rows]
void reference_varying_sweep(ConductanceMean mean, std::span<const std::int64_t> row_begin,
                             std::span<const std::int32_t> column, std::span<const double> geometry,
                             std::span<const double> conductivity, const Stage& stage, double* out) noexcept;

}  // namespace superstep
