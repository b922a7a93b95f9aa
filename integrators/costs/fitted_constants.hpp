#pragma once
/// What methods cost: the constants that `auto` and `exponential` choose by, written by `superstep fit`.
///
/// 497 points of 21 scenes; AMD EPYC; revision 642a3394470e-dirty; 2026-11-26;
/// superstep fit quick/corpus.csv more/corpus.csv middle/corpus.csv
///
/// sweep_row, sweep_nonzero and lanczos_row are of 26 November 2026, from the NiAl cylinder alone (50 us a
/// sweep, 73 us a vector of Lanczos): the corpora above have no nonzeros.

#include "integrators/costs/constants.hpp"

namespace superstep::fitted {

constexpr CostConstants constants() {
  CostConstants c;
  // s; a sweep over the network, each unknown
  c.sweep_row = 1e-09;
  // s; the same, each nonzero off the diagonal
  c.sweep_nonzero = 2.7e-10;
  // s; a sweep, however small
  c.sweep_call = 8.58e-08;
  // sweeps; f where a potential drives the temperature
  c.one_way_sweeps = 1.92;
  // sweeps; f where coefficients follow the field
  c.nonlinear_sweeps = 2.78;
  // sweeps; f of two fields that act on each other
  c.coupled_sweeps = 5.72;
  // s; a steady potential on 1000 unknowns, growing as their square
  c.steady_solve = 0.000609;
  // -; spectral radius of two coupled fields over the bound of it at zero
  c.coupled_radius = 15;
  // -; terms over sqrt(t rho pieces ln(1/rtol))
  c.chebyshev_terms = 0.725;
  // sweeps; the search for a sharp radius
  c.chebyshev_radius = 43.5;
  // -; what squares of a potential at many instants cost more
  c.chebyshev_one_way = 4.61;
  // -; vectors over sqrt(t rho)
  c.lanczos_vectors = 0.277;
  // -; vectors more over sqrt(t rho) ln(1/rtol)
  c.lanczos_digit = 0.0696;
  // s; a vector's sums and its part of results, each unknown
  c.lanczos_row = 1.5e-09;
  // s; a vector, however small
  c.lanczos_vector = 2.18e-06;
  // s; the small problem, each pair of vectors
  c.lanczos_pair = 2.6e-10;
  // s; all of it, however small
  c.invert_call = 1.94e-05;
  // sweeps; analysis of the matrix
  c.invert_analysis = 349;
  // sweeps; a factorization of 16 538 unknowns, growing as their square
  c.invert_factor = 2.19e+03;
  // sweeps; a solve of 16 538 unknowns, growing as their power of 4/3
  c.invert_solve = 38.4;
  // -; steps at rtol 1e-4
  c.rock_steps = 20.1;
  // -; power of 1/rtol that they grow by
  c.rock_growth = 0.245;
  // -; steps more for a breakpoint
  c.rock_piece = 0.92;
  // -; stability interval over stages squared
  c.rock_interval = 0.259;
  // -; stages more of a step
  c.rock_finish = 1.46;
  // s; a step, however small
  c.rock_step = 7.99e-07;
  // -; steps at rtol 1e-4
  c.exprb_steps = 1.66;
  // -; power of 1/rtol that they grow by
  c.exprb_growth = 0.533;
  // -; the same where the Jacobian leaves out what a steady potential does
  c.exprb_steady_growth = 0.875;
  // -; steps more for a breakpoint
  c.exprb_piece = 1.55;
  // -; vectors over sqrt(steps t rho)
  c.exprb_vectors = 5;
  // -; vectors more of a step
  c.exprb_few = 0.932;
  // sweeps; a vector
  c.exprb_product = 1.37;
  // s; a vector, however small
  c.exprb_vector = 6.69e-07;
  // -; steps at rtol 1
  c.bdf_steps = 2.68;
  // -; power of 1/rtol that they grow by
  c.bdf_growth = 0.12;
  // -; part that they grow by with a decade of t rho
  c.bdf_decades = 2.41;
  // -; steps more for a breakpoint
  c.bdf_piece = 15.8;
  // sweeps; a step by conjugate gradients, 16 538 unknowns, growing as their power of 0.43
  c.bdf_pcg = 180;
  // sweeps; the same by GMRES
  c.bdf_gmres = 272;
  // sweeps; the same by a factorization, growing as their power of 2/3
  c.bdf_direct = 336;
  // s; a step, however small
  c.bdf_step = 4.7e-06;
  return c;
}

}  // namespace superstep::fitted
