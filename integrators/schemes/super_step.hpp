#pragma once
/// Super-time-stepping: substeps, their orders and the length of a superstep.
/// Source: Alexiades, Amiez & Gremaud (1996),
/// doi:10.1002/(SICI)1099-0887(199601)12:1<31::AID-CNM950>3.0.CO;2-5; Rojek & Nisar 2026, eqs 22-26.

#include <vector>

namespace superstep {

/// Length of a superstep of n substeps over the critical step [-]: sum of tau_j / h_cr in closed form;
/// tends to n^2 as nu -> 0. 0 < nu < 1, n >= 1.
[[nodiscard]] double superstep_length(int n, double nu) noexcept;

/// Substeps over the critical step, tau_j / h_cr, in the natural order j = 1 .. n (longest first).
[[nodiscard]] std::vector<double> superstep_substeps(int n, double nu);

/// The same substeps in Leja order of their nodes 1/tau, which keeps partial products, and with them
/// rounding, small.
[[nodiscard]] std::vector<double> leja_ordered(std::vector<double> substeps);

/// Polynomial of a superstep in closed form, T_n((1 + nu - x)/(1 - nu)) / T_n((1 + nu)/(1 - nu)), at x = rate
/// * critical step; 0 <= x <= 2 is stable. Long double, so that it can serve as the truth beside computed
/// supersteps.
[[nodiscard]] long double superstep_response(int n, double nu, long double x);

/// Substeps and damping of a superstep.
struct SuperstepShape {
  int n;
  double nu;
};
/// The 15 published sets (Rojek & Nisar 2026, table 2) and two that natural order does not survive.
[[nodiscard]] std::vector<SuperstepShape> superstep_shapes(bool quick);
inline constexpr const char* superstep_orders[] = {"recurrence", "leja", "natural"};

}  // namespace superstep
