#include "integrators/costs/constants.hpp"

#include <array>

namespace superstep {

std::span<const CostConstant> cost_constants() {
  using C = CostConstants;
  static constexpr std::array list = {
      CostConstant{"sweep_row", &C::sweep_row, "s; a sweep over the network, each unknown"},
      CostConstant{"sweep_nonzero", &C::sweep_nonzero, "s; the same, each nonzero off the diagonal"},
      CostConstant{"sweep_call", &C::sweep_call, "s; a sweep, however small"},
      CostConstant{"one_way_sweeps", &C::one_way_sweeps,
                   "sweeps; f where a potential drives the temperature"},
      CostConstant{"nonlinear_sweeps", &C::nonlinear_sweeps, "sweeps; f where coefficients follow the field"},
      CostConstant{"coupled_sweeps", &C::coupled_sweeps, "sweeps; f of two fields that act on each other"},
      CostConstant{"steady_solve", &C::steady_solve,
                   "s; a steady potential on 1000 unknowns, growing as their square"},
      CostConstant{"coupled_radius", &C::coupled_radius,
                   "-; spectral radius of two coupled fields over the bound of it at zero"},
      CostConstant{"chebyshev_terms", &C::chebyshev_terms, "-; terms over sqrt(t rho pieces ln(1/rtol))"},
      CostConstant{"chebyshev_radius", &C::chebyshev_radius, "sweeps; the search for a sharp radius"},
      CostConstant{"chebyshev_one_way", &C::chebyshev_one_way,
                   "-; what squares of a potential at many instants cost more"},
      CostConstant{"lanczos_vectors", &C::lanczos_vectors, "-; vectors over sqrt(t rho)"},
      CostConstant{"lanczos_digit", &C::lanczos_digit, "-; vectors more over sqrt(t rho) ln(1/rtol)"},
      CostConstant{"lanczos_row", &C::lanczos_row,
                   "s; a vector's sums and its part of results, each unknown"},
      CostConstant{"lanczos_vector", &C::lanczos_vector, "s; a vector, however small"},
      CostConstant{"lanczos_pair", &C::lanczos_pair, "s; the small problem, each pair of vectors"},
      CostConstant{"invert_call", &C::invert_call, "s; all of it, however small"},
      CostConstant{"invert_analysis", &C::invert_analysis, "sweeps; analysis of the matrix"},
      CostConstant{"invert_factor", &C::invert_factor,
                   "sweeps; a factorization of 16 538 unknowns, growing as their square"},
      CostConstant{"invert_solve", &C::invert_solve,
                   "sweeps; a solve of 16 538 unknowns, growing as their power of 4/3"},
      CostConstant{"rock_steps", &C::rock_steps, "-; steps at rtol 1e-4"},
      CostConstant{"rock_growth", &C::rock_growth, "-; power of 1/rtol that they grow by"},
      CostConstant{"rock_piece", &C::rock_piece, "-; steps more for a breakpoint"},
      CostConstant{"rock_interval", &C::rock_interval, "-; stability interval over stages squared"},
      CostConstant{"rock_finish", &C::rock_finish, "-; stages more of a step"},
      CostConstant{"rock_step", &C::rock_step, "s; a step, however small"},
      CostConstant{"exprb_steps", &C::exprb_steps, "-; steps at rtol 1e-4"},
      CostConstant{"exprb_growth", &C::exprb_growth, "-; power of 1/rtol that they grow by"},
      CostConstant{"exprb_steady_growth", &C::exprb_steady_growth,
                   "-; the same where the Jacobian leaves out what a steady potential does"},
      CostConstant{"exprb_piece", &C::exprb_piece, "-; steps more for a breakpoint"},
      CostConstant{"exprb_vectors", &C::exprb_vectors, "-; vectors over sqrt(steps t rho)"},
      CostConstant{"exprb_few", &C::exprb_few, "-; vectors more of a step"},
      CostConstant{"exprb_product", &C::exprb_product, "sweeps; a vector"},
      CostConstant{"exprb_vector", &C::exprb_vector, "s; a vector, however small"},
      CostConstant{"bdf_steps", &C::bdf_steps, "-; steps at rtol 1"},
      CostConstant{"bdf_growth", &C::bdf_growth, "-; power of 1/rtol that they grow by"},
      CostConstant{"bdf_decades", &C::bdf_decades, "-; part that they grow by with a decade of t rho"},
      CostConstant{"bdf_piece", &C::bdf_piece, "-; steps more for a breakpoint"},
      CostConstant{"bdf_pcg", &C::bdf_pcg,
                   "sweeps; a step by conjugate gradients, 16 538 unknowns, growing as their power of 0.43"},
      CostConstant{"bdf_gmres", &C::bdf_gmres, "sweeps; the same by GMRES"},
      CostConstant{"bdf_direct", &C::bdf_direct,
                   "sweeps; the same by a factorization, growing as their power of 2/3"},
      CostConstant{"bdf_step", &C::bdf_step, "s; a step, however small"},
  };
  return list;
}

}  // namespace superstep
