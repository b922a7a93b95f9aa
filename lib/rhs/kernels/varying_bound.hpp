#pragma once
/// Row sums of a Jacobian whose conductances follow a state, without forming it: what bounds of its spectrum
/// are made of.

#include <span>

#include "rhs/conductance_mean.hpp"
#include "rhs/kernels/sliced_rows.hpp"
#include "rhs/kernels/varying_sweep.hpp"

namespace superstep {

/// |ds/dT| of a conductivity and its slope, see `node_factor`.
[[nodiscard]] inline double node_bend(ConductanceMean mean, double conductivity, double slope) noexcept {
  const double magnitude = slope < 0 ? -slope : slope;
  return mean == ConductanceMean::harmonic ? magnitude / conductivity / conductivity : magnitude;
}

/// With K_ij = g_ij m(s_i, s_j), m as in `varying_sweep`, and v the values of the nodes, of row i
///   conduction  sum_j K_ij
///   laws        sum_j |dK_ij/dT_i (v_j - v_i)| + |dK_ij/dT_j (v_j - v_i)|
struct JacobianSums {
  std::span<double> conduction, laws;  ///< [rows]
};

/// With Q_i = sum_j g_ij h(s_i, s_j) (v_j - v_i)^2 / C_i, the heat of `varying_heat`, of row i
///   temperatures  sum_j |dQ_i/dT_i| + |dQ_i/dT_j|, each branch by itself
///   potentials    sum_j |dQ_i/dv_i| + |dQ_i/dv_j|, likewise
struct HeatSums {
  std::span<double> temperatures, potentials;  ///< [rows], added to
};
/// What the heat of a row may depend on [columns].
struct HeatColumns {
  const NodePair* nodes;  ///< potential and s
  const double* bend;     ///< |ds/dT|, 0 where the temperature is known
  const double* moves;    ///< 1 where the potential may move, 0 where it is known
};

/// The kernels of one instruction set. They work on whole slices [first, last).
struct BoundKernel {
  using Sums = void (*)(const SlicedRows& geometry, const NodePair* nodes, const double* bend,
                        std::size_t first, std::size_t last, const JacobianSums& out) noexcept;
  using Heat = void (*)(const SlicedRows& geometry, const HeatColumns& columns,
                        const double* inverse_capacity, std::size_t first, std::size_t last,
                        const HeatSums& out) noexcept;
  const char* name;
  Sums harmonic, arithmetic;
  Heat harmonic_heat, arithmetic_heat;
};
/// Those that this machine can run, the one in use first.
[[nodiscard]] std::span<const BoundKernel> bound_kernels() noexcept;

/// The sums of all rows.
///   geometry  as that of `varying_sweep`;  nodes, bend  of all columns;  bend is |ds/dT|, 0 where the
///             temperature of a node is known
void varying_row_sums(ConductanceMean mean, const SlicedRows& geometry, const NodePair* nodes,
                      const double* bend, const JacobianSums& out) noexcept;
/// The same of the heat; `geometry` as that of `varying_heat`.
void varying_heat_sums(ConductanceMean mean, const SlicedRows& geometry, const HeatColumns& columns,
                       const double* inverse_capacity, const HeatSums& out) noexcept;

}  // namespace superstep
