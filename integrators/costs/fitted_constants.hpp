#pragma once
/// What methods cost: the constants that `auto` and `exponential` choose by, written by `superstep fit`.
///
/// 528 points of 21 scenes; AMD EPYC; revision 77a284b4a60a-dirty, e7b52d734cef-dirty; 2026-11-26;
/// superstep fit quick/corpus.csv more/corpus.csv middle/corpus.csv

#include "integrators/costs/constants.hpp"

namespace superstep::fitted {

constexpr CostConstants constants() {
  CostConstants c;
  // s; a sweep over the network, each unknown
  c.sweep_row = 2e-09;
  // s; a sweep, however small
  c.sweep_call = 3.65e-08;
  // sweeps; f where a potential drives the temperature
  c.one_way_sweeps = 1.76;
  // sweeps; f where coefficients follow the field
  c.nonlinear_sweeps = 3.67;
  // sweeps; f of two fields that act on each other
  c.coupled_sweeps = 4.95;
  // s; a steady potential on 1000 unknowns, growing as their square
  c.steady_solve = 0.000562;
  // -; spectral radius of two coupled fields over the bound of it at zero
  c.coupled_radius = 39.3;
  // -; terms over sqrt(t rho pieces ln(1/rtol))
  c.chebyshev_terms = 0.96;
  // sweeps; the search for a sharp radius
  c.chebyshev_radius = 77.7;
  // -; what squares of a potential at many instants cost more
  c.chebyshev_one_way = 4.76;
  // -; vectors over sqrt(t rho)
  c.lanczos_vectors = 0.299;
  // -; vectors more over sqrt(t rho) ln(1/rtol)
  c.lanczos_digit = 0.0131;
  // sweeps; a vector with its sums and its part of results
  c.lanczos_product = 10.3;
  // s; a vector, however small
  c.lanczos_vector = 3.01e-06;
  // s; the small problem, each pair of vectors
  c.lanczos_pair = 8.8e-10;
  // s; all of it, however small
  c.invert_call = 3.5e-06;
  // sweeps; analysis of the matrix
  c.invert_analysis = 141;
  // sweeps; a factorization of 16 538 unknowns, growing as their square
  c.invert_factor = 2.32e+03;
  // sweeps; a solve of 16 538 unknowns, growing as their power of 4/3
  c.invert_solve = 98.7;
  // -; steps at rtol 1e-4
  c.rock_steps = 19.3;
  // -; power of 1/rtol that they grow by
  c.rock_growth = 0.262;
  // -; steps more for a breakpoint
  c.rock_piece = 1.93;
  // -; stability interval over stages squared
  c.rock_interval = 0.149;
  // -; stages more of a step
  c.rock_finish = 1.13;
  // s; a step, however small
  c.rock_step = 1.24e-06;
  // -; steps at rtol 1e-4
  c.exprb_steps = 6.71;
  // -; power of 1/rtol that they grow by
  c.exprb_growth = 0.463;
  // -; the same where the Jacobian leaves out what a steady potential does
  c.exprb_steady_growth = 0.541;
  // -; steps more for a breakpoint
  c.exprb_piece = 10.8;
  // -; vectors over sqrt(steps t rho)
  c.exprb_vectors = 2.82;
  // -; vectors more of a step
  c.exprb_few = 1.35;
  // sweeps; a vector
  c.exprb_product = 2.75;
  // s; a vector, however small
  c.exprb_vector = 4.47e-07;
  // -; steps at rtol 1
  c.bdf_steps = 2.31;
  // -; power of 1/rtol that they grow by
  c.bdf_growth = 0.118;
  // -; part that they grow by with a decade of t rho
  c.bdf_decades = 3.07;
  // -; steps more for a breakpoint
  c.bdf_piece = 19.6;
  // sweeps; a step by conjugate gradients, 16 538 unknowns, growing as their power of 0.43
  c.bdf_pcg = 280;
  // sweeps; the same by GMRES
  c.bdf_gmres = 472;
  // sweeps; the same by a factorization, growing as their power of 2/3
  c.bdf_direct = 454;
  // s; a step, however small
  c.bdf_step = 2.72e-06;
  return c;
}

}  // namespace superstep::fitted
