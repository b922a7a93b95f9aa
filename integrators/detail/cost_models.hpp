#pragma once
/// What methods cost, in sweeps over the network: every constant that `auto` and `exponential` choose by,
/// with where it comes from. Predicted, never measured while running, so that a choice is the same on every
/// machine.
///
/// Origins: [n] reports/records/work_precision_nial_thermal.csv, the cylinder of the source paper (16 538
/// unknowns, t rho = 5.8e4 with the certified rho), on which one sweep takes 43 us; [t]
/// record_nial_thermoelectric.csv there; [q] `superstep bench --corpus quick`, 100 to 2 400 unknowns; [l]
/// lattices of 9 680, 93 104 and 980 000.

namespace superstep::costs {

inline constexpr double usual_size = 16'538;  ///< unknowns [n]

/// Seconds of a sweep on the machine that the constants come from: what does not grow with the network is
/// divided by it. [n, q: 2.1 to 2.9 ns a row in cache, 0.35 us of chain of 200]
inline constexpr double sweep_of_row = 2.6e-9, sweep_at_least = 0.2e-6;
[[nodiscard]] constexpr double sweep(double unknowns) noexcept {
  return sweep_of_row * unknowns + sweep_at_least;
}

/// Chebyshev: terms, times sqrt(t rho ln(1/rtol)); sweeps for the sharper radius that it works with. [n: 480
/// to 1016 sweeps for rtol 1e-3 to 1e-12, within 12 %]
inline constexpr double chebyshev_terms = 0.78, chebyshev_radius = 36;
/// The same where a potential drives the temperature: squares of the potential at many instants. [t: 6734
/// sweeps at 5e-6 where terms alone are 1930; q: 845 to 1825 where they are 183 to 340]
inline constexpr double chebyshev_one_way = 3.8;

/// Lanczos: vectors over sqrt(t rho), and what they grow by with ln(1/rtol). [n: 134, 227, 307, 458 for rtol
/// 1e-2, 1e-4, 1e-6, 1e-10, within 5 %]
inline constexpr double lanczos_vectors = 0.22, lanczos_vectors_of_digit = 0.0734, lanczos_few = 8;
/// A product with its sums and its part of the results, in sweeps [n]; what a vector takes besides however
/// small the network is, and what the small problem takes for every pair of vectors [s]. [q: 6 us a vector at
/// 1 000 unknowns where a sweep takes 1.4; 0.6 ms for 101 vectors of 100 entries]
inline constexpr double lanczos_product = 1.8, lanczos_vector = 4e-6, lanczos_pair = 10e-9;

/// Shift-and-invert at the usual size: analysis; a factorization; a solve. [n: 600, 700, 45; q: 0.18 ms in
/// all for 100 unknowns, 1.0 ms for 713]
inline constexpr double invert_analysis = 400, invert_factor = 700, invert_solve = 45;

/// ROCK4: steps at rtol 1e-4, how they grow, steps more for a breakpoint; sweeps of a step beyond the square
/// root of h rho over the interval of a stage. [n: 1846, 2694, 4891 sweeps for rtol 1e-4, 1e-6, 1e-8; q: 450
/// to 900 at 1e-4 and 2000 to 4300 at 1e-8 with t rho of 1e3 to 1e4]
inline constexpr double rock_steps = 15, rock_growth = 0.25, rock_steps_of_piece = 6;
inline constexpr double rock_interval = 0.35, rock_finish = 4;

/// BDF: steps at rtol 1, how they grow, and with the decades between the fastest and the slowest scale. [n:
/// 91, 167, 329 for rtol 1e-4, 1e-6, 1e-8]
inline constexpr double bdf_steps = 25, bdf_growth = 0.125, bdf_decades = 0.1;
/// Work of a step at the usual size: by conjugate gradients, growing as n^0.43, and by a factorization,
/// growing with the fill of a three-dimensional network. [n, l: 110, 210, 650 sweeps; n: 315]
inline constexpr double bdf_iterative = 115, bdf_iterative_growth = 0.43, bdf_direct = 315;
inline constexpr double bdf_direct_growth = 2.0 / 3.0, bdf_sweeps = 2;

}  // namespace superstep::costs
