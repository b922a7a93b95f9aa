#pragma once
/// What methods cost: the constants that `auto` and `exponential` choose by, written by `superstep fit`.
///
/// 547 points of 21 scenes; AMD EPYC; revision 88ff48ca8ce0-dirty; 2026-11-26;
/// superstep fit quick/corpus.csv more/corpus.csv middle/corpus.csv

#include "integrators/costs/constants.hpp"

namespace superstep::fitted {

constexpr CostConstants constants() {
  CostConstants c;
  // s; a sweep over the network, each unknown
  c.sweep_row = 3.99e-10;
  // s; the same, each nonzero off the diagonal
  c.sweep_nonzero = 3.18e-10;
  // s; a sweep, however small
  c.sweep_call = 2.3e-07;
  // sweeps; f where a potential drives the temperature
  c.one_way_sweeps = 1.64;
  // sweeps; f where coefficients follow the field
  c.nonlinear_sweeps = 2.34;
  // sweeps; f of two fields that act on each other
  c.coupled_sweeps = 5.17;
  // s; a steady potential on 1000 unknowns, growing as their square
  c.steady_solve = 0.000556;
  // -; spectral radius of two coupled fields over the bound of it at zero
  c.coupled_radius = 13.7;
  // -; terms over sqrt(t rho pieces ln(1/rtol))
  c.chebyshev_terms = 1.03;
  // sweeps; the search for a sharp radius
  c.chebyshev_radius = 26.2;
  // -; what squares of a potential at many instants cost more
  c.chebyshev_one_way = 4.75;
  // -; vectors over sqrt(t rho)
  c.lanczos_vectors = 0.229;
  // -; vectors more over sqrt(t rho) ln(1/rtol)
  c.lanczos_digit = 0.0759;
  // s; a vector's sums and its part of results, each unknown
  c.lanczos_row = 3.24e-09;
  // s; a vector, however small
  c.lanczos_vector = 1.44e-06;
  // s; the small problem, each pair of vectors
  c.lanczos_pair = 1.26e-09;
  // s; all of it, however small
  c.invert_call = 1.36e-05;
  // sweeps; analysis of the matrix
  c.invert_analysis = 311;
  // sweeps; a factorization of 16 538 unknowns, growing as their square
  c.invert_factor = 700;
  // sweeps; a solve of 16 538 unknowns, growing as their power of 4/3
  c.invert_solve = 79.6;
  // -; steps at rtol 1e-4
  c.rock_steps = 26;
  // -; power of 1/rtol that they grow by
  c.rock_growth = 0.242;
  // -; steps more for a breakpoint
  c.rock_piece = 1.2;
  // -; stability interval over stages squared
  c.rock_interval = 0.181;
  // -; stages more of a step
  c.rock_finish = 1.06;
  // s; a step, however small
  c.rock_step = 1.36e-06;
  // -; steps at rtol 1e-4
  c.exprb_steps = 2.47;
  // -; power of 1/rtol that they grow by
  c.exprb_growth = 0.525;
  // -; the same where the Jacobian leaves out what a steady potential does
  c.exprb_steady_growth = 0.862;
  // -; steps more for a breakpoint
  c.exprb_piece = 1.05;
  // -; vectors over sqrt(steps t rho)
  c.exprb_vectors = 4.85;
  // -; vectors more of a step
  c.exprb_few = 0.53;
  // sweeps; a vector
  c.exprb_product = 1.37;
  // s; a vector, however small
  c.exprb_vector = 6.22e-07;
  // -; steps at rtol 1
  c.bdf_steps = 2.76;
  // -; power of 1/rtol that they grow by
  c.bdf_growth = 0.123;
  // -; part that they grow by with a decade of t rho
  c.bdf_decades = 3.1;
  // -; steps more for a breakpoint
  c.bdf_piece = 22.7;
  // sweeps; a step by conjugate gradients, 16 538 unknowns, growing as their power of 0.43
  c.bdf_pcg = 140;
  // sweeps; the same by GMRES
  c.bdf_gmres = 202;
  // sweeps; the same by a factorization, growing as their power of 2/3
  c.bdf_direct = 260;
  // s; a step, however small
  c.bdf_step = 3.85e-06;
  return c;
}

}  // namespace superstep::fitted
