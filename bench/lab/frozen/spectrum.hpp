#pragma once
/// Where the eigenvalues of a frozen Jacobian lie, as far as stability asks.

#include <complex>
#include <string>
#include <vector>

#include "bench/lab/frozen/frozen_rhs.hpp"
#include "bench/lab/frozen/growth.hpp"

namespace superstep {

struct Spectrum {
  enum class Kind { symmetric, real, complex };
  Kind kind = Kind::symmetric;
  std::string found_by;  ///< "Lanczos", "all eigenvalues" or "Arnoldi"
  /// The eigenvalue that limits forward Euler's step, with its sign; the stiffest of a real spectrum [1/s].
  std::complex<double> limiting;
  double residual = 0;        ///< |J v - lambda v| of its shape [1/s]
  std::vector<double> shape;  ///< norm 1 in the weights; the real part of a complex one
  /// Where all eigenvalues were computed: those that a step may not let grow, neither rising by themselves
  /// nor so slow that rounding hides what becomes of them.
  std::vector<Mode> modes;
  double rising = 0;  ///< largest real part where some perturbations grow by themselves, else 0 [1/s]
  /// False where eigenvalues were not all computed and none of those found shows that one rises: it may be
  /// far from the stiff end.
  bool rising_is_known = true;
  double euler_limit = 0;  ///< longest stable step of forward Euler [s]
};

/// Unknowns up to which every eigenvalue is computed.
constexpr std::size_t most_for_all_eigenvalues = 250;

/// Lanczos where J is symmetric; else all eigenvalues of a small scene and restarted Arnoldi on a large one.
[[nodiscard]] Spectrum spectrum_of(FrozenRhs& rhs);

/// The longest stable step of forward Euler for one eigenvalue: 2a/(a^2 + b^2) of -a +- ib; infinity where a
/// perturbation grows by itself [s].
[[nodiscard]] double euler_limit(std::complex<double> eigenvalue) noexcept;

}  // namespace superstep
