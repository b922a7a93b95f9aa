#pragma once
/// The constants that costs are predicted by. `superstep fit` finds them from measurements and writes
/// fitted_constants.hpp; what stands here is known without any: counts of operations, and the theory of the
/// methods.

#include <span>

namespace superstep {

/// All > 0. Seconds are those of the machine that was measured on; choices hang on their quotients.
struct CostConstants {
  double sweep_row = 1e-9, sweep_nonzero = 3e-10, sweep_call = 2e-7;
  double one_way_sweeps = 2, nonlinear_sweeps = 2, coupled_sweeps = 4;
  double steady_solve = 1e-3;
  double coupled_radius = 2;

  double chebyshev_terms = 0.78, chebyshev_radius = 36, chebyshev_one_way = 3;

  double lanczos_vectors = 0.22, lanczos_digit = 0.07, lanczos_row = 1.5e-9;
  double lanczos_vector = 2e-6, lanczos_pair = 1e-8;

  double invert_call = 3e-5, invert_analysis = 400, invert_factor = 700, invert_solve = 45;

  double rock_steps = 15, rock_growth = 0.25, rock_piece = 6, rock_interval = 0.35, rock_finish = 4;
  double rock_step = 2e-6;

  double exprb_steps = 15, exprb_growth = 0.33, exprb_steady_growth = 1, exprb_piece = 4, exprb_vectors = 1,
         exprb_few = 12;
  double exprb_product = 2, exprb_vector = 2e-6;

  double bdf_steps = 25, bdf_growth = 0.125, bdf_decades = 0.1, bdf_piece = 15;
  double bdf_pcg = 115, bdf_gmres = 115, bdf_direct = 315, bdf_step = 5e-6;
};

/// One of them, for those who fit and print.
struct CostConstant {
  const char* name;
  double CostConstants::*value;
  const char* meaning;  ///< with its unit
};
[[nodiscard]] std::span<const CostConstant> cost_constants();

}  // namespace superstep
