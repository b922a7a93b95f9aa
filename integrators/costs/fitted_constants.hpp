#pragma once
/// What methods cost: the constants that `auto` and `exponential` choose by, written by `superstep fit`.
///
/// 547 points of 22 scenes; AMD EPYC; revision de60ec455e9f-dirty; 2026-11-27;
/// superstep fit quick/corpus.csv larger/corpus.csv

#include "integrators/costs/constants.hpp"

namespace superstep::fitted {

constexpr CostConstants constants() {
  CostConstants c;
  // s; a sweep over the network, each unknown
  c.sweep_row = 2.38e-11;
  // s; the same, each nonzero off the diagonal
  c.sweep_nonzero = 2.98e-10;
  // s; a sweep, however small
  c.sweep_call = 3.18e-07;
  // sweeps; f where a potential drives the temperature
  c.one_way_sweeps = 1.84;
  // sweeps; f where coefficients follow the field
  c.nonlinear_sweeps = 2.34;
  // sweeps; f of two fields that act on each other
  c.coupled_sweeps = 5.1;
  // s; a steady potential on 1000 unknowns, growing as their square
  c.steady_solve = 0.000363;
  // -; spectral radius of two coupled fields over the bound of it at zero
  c.coupled_radius = 9.8;
  // -; terms over sqrt(t rho pieces ln(1/rtol))
  c.chebyshev_terms = 1.25;
  // sweeps; the search for a sharp radius
  c.chebyshev_radius = 40.1;
  // -; what squares of a potential at many instants cost more
  c.chebyshev_one_way = 3.69;
  // -; vectors over sqrt(t rho)
  c.lanczos_vectors = 0.171;
  // -; vectors more over sqrt(t rho) ln(1/rtol)
  c.lanczos_digit = 0.0736;
  // s; a vector's sums and its part of results, each unknown
  c.lanczos_row = 2.87e-09;
  // s; a vector, however small
  c.lanczos_vector = 2.66e-06;
  // s; the small problem, each pair of vectors
  c.lanczos_pair = 4.36e-10;
  // s; all of it, however small
  c.invert_call = 1.47e-05;
  // sweeps; analysis of the matrix
  c.invert_analysis = 301;
  // sweeps; a factorization of 16 538 unknowns, growing as their square
  c.invert_factor = 2.17e+03;
  // sweeps; a solve of 16 538 unknowns, growing as their power of 4/3
  c.invert_solve = 94.3;
  // -; steps at rtol 1e-4
  c.rock_steps = 18.5;
  // -; power of 1/rtol that they grow by
  c.rock_growth = 0.263;
  // -; steps more for a breakpoint
  c.rock_piece = 2.56;
  // -; stability interval over stages squared
  c.rock_interval = 0.107;
  // -; stages more of a step
  c.rock_finish = 1.85;
  // s; a step, however small
  c.rock_step = 6.94e-07;
  // -; steps at rtol 1e-4
  c.exprb_steps = 3.63;
  // -; power of 1/rtol that they grow by
  c.exprb_growth = 0.523;
  // -; the same where the Jacobian leaves out what a steady potential does
  c.exprb_steady_growth = 0.757;
  // -; steps more for a breakpoint
  c.exprb_piece = 10.4;
  // -; vectors over sqrt(steps t rho)
  c.exprb_vectors = 1.73;
  // -; vectors more of a step
  c.exprb_few = 1.3;
  // sweeps; a vector
  c.exprb_product = 5.21;
  // s; a vector, however small
  c.exprb_vector = 1.47e-07;
  // -; steps at rtol 1
  c.bdf_steps = 1.23;
  // -; power of 1/rtol that they grow by
  c.bdf_growth = 0.111;
  // -; part that they grow by with a decade of t rho
  c.bdf_decades = 6.07;
  // -; steps more for a breakpoint
  c.bdf_piece = 15;
  // sweeps; a step by conjugate gradients, 16 538 unknowns, growing as their power of 0.43
  c.bdf_pcg = 263;
  // sweeps; the same by GMRES
  c.bdf_gmres = 404;
  // sweeps; the same by a factorization, growing as their power of 2/3
  c.bdf_direct = 450;
  // s; a step, however small
  c.bdf_step = 5.59e-06;
  return c;
}

}  // namespace superstep::fitted
