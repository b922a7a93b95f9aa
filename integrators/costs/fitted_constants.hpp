#pragma once
/// What methods cost: the constants that `auto` and `exponential` choose by, written by `superstep fit`.
///
/// 539 points of 21 scenes; AMD EPYC; revision 77a284b4a60a-dirty, e7b52d734cef-dirty; 2026-11-26;
/// superstep fit quick/corpus.csv more/corpus.csv middle/corpus.csv

#include "integrators/costs/constants.hpp"

namespace superstep::fitted {

constexpr CostConstants constants() {
  CostConstants c;
  // s; a sweep over the network, each unknown
  c.sweep_row = 1.92e-09;
  // s; a sweep, however small
  c.sweep_call = 6.18e-08;
  // sweeps; f where a potential drives the temperature
  c.one_way_sweeps = 2.37;
  // sweeps; f where coefficients follow the field
  c.nonlinear_sweeps = 2.63;
  // sweeps; f of two fields that act on each other
  c.coupled_sweeps = 4.99;
  // s; a steady potential on 1000 unknowns, growing as their square
  c.steady_solve = 0.00062;
  // -; spectral radius of two coupled fields over the bound of it at zero
  c.coupled_radius = 15.1;
  // -; terms over sqrt(t rho pieces ln(1/rtol))
  c.chebyshev_terms = 0.902;
  // sweeps; the search for a sharp radius
  c.chebyshev_radius = 79;
  // -; what squares of a potential at many instants cost more
  c.chebyshev_one_way = 4.71;
  // -; vectors over sqrt(t rho)
  c.lanczos_vectors = 0.353;
  // -; vectors more over sqrt(t rho) ln(1/rtol)
  c.lanczos_digit = 0.0146;
  // sweeps; a vector with its sums and its part of results
  c.lanczos_product = 7.87;
  // s; a vector, however small
  c.lanczos_vector = 2.79e-06;
  // s; the small problem, each pair of vectors
  c.lanczos_pair = 1.19e-09;
  // s; all of it, however small
  c.invert_call = 9.97e-06;
  // sweeps; analysis of the matrix
  c.invert_analysis = 266;
  // sweeps; a factorization of 16 538 unknowns, growing as their square
  c.invert_factor = 2.88e+03;
  // sweeps; a solve of 16 538 unknowns, growing as their power of 4/3
  c.invert_solve = 72.9;
  // -; steps at rtol 1e-4
  c.rock_steps = 23.8;
  // -; power of 1/rtol that they grow by
  c.rock_growth = 0.25;
  // -; steps more for a breakpoint
  c.rock_piece = 0.468;
  // -; stability interval over stages squared
  c.rock_interval = 0.151;
  // -; stages more of a step
  c.rock_finish = 1.03;
  // s; a step, however small
  c.rock_step = 4.23e-07;
  // -; steps at rtol 1e-4
  c.exprb_steps = 4.77;
  // -; power of 1/rtol that they grow by
  c.exprb_growth = 0.466;
  // -; steps more for a breakpoint
  c.exprb_piece = 2.97;
  // -; vectors over sqrt(steps t rho)
  c.exprb_vectors = 5.49;
  // -; vectors more of a step
  c.exprb_few = 0.838;
  // sweeps; a vector
  c.exprb_product = 1.35;
  // s; a vector, however small
  c.exprb_vector = 1.3e-06;
  // -; steps at rtol 1
  c.bdf_steps = 5.67;
  // -; power of 1/rtol that they grow by
  c.bdf_growth = 0.114;
  // -; part that they grow by with a decade of t rho
  c.bdf_decades = 1.33;
  // -; steps more for a breakpoint
  c.bdf_piece = 25.7;
  // sweeps; a step by conjugate gradients, 16 538 unknowns, growing as their power of 0.43
  c.bdf_pcg = 188;
  // sweeps; the same by GMRES
  c.bdf_gmres = 321;
  // sweeps; the same by a factorization, growing as their power of 2/3
  c.bdf_direct = 320;
  // s; a step, however small
  c.bdf_step = 3.93e-06;
  return c;
}

}  // namespace superstep::fitted
