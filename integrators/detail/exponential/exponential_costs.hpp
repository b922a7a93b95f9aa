#pragma once
/// What the bases of the matrix exponential would cost on a scene: predicted, never measured while running,
/// so that the choice is the same on every machine.

#include <string>

#include "integrators/integrator.hpp"

namespace superstep {

/// A run of the exponential, as far as its cost depends on it.
struct ExponentialWork {
  double t_rho = 0;  ///< time times the certified bound of the spectral radius [-]
  double rtol = 0;   ///< [-]
  double unknowns = 0;
  double output_decades = 0;  ///< log10 of the last output time over the first, both from the start
  double memory = 0;          ///< that a basis or a factor may take [bytes]
  bool one_field = true;      ///< else only polynomials known beforehand will do
  double pieces = 1;          ///< between breakpoints of the inputs
  double shapes = 0;          ///< of inputs that change in time: each needs a space of its own
};

/// Work of one basis; infinity where it is not for this scene.
struct ExponentialCosts {
  double chebyshev = 0, lanczos = 0, shift_invert = 0;  ///< in sweeps over the network

  /// "chebyshev", "lanczos" or "shift-invert".
  [[nodiscard]] std::string cheapest() const;
  [[nodiscard]] double least() const;
  /// As in "lanczos, because it costs about 190 sweeps; chebyshev 560, shift-invert 4000".
  [[nodiscard]] std::string reason() const;
};

/// Of `memory` where nobody says otherwise [bytes].
constexpr double default_memory = 0x1p30;

/// What a task asks of the exponential at a tolerance. Where a potential drives the temperature the inputs of
/// the temperature count as changing.
[[nodiscard]] ExponentialWork work_of_exponential(Rhs& rhs, const Task& task, double rtol,
                                                  double memory = default_memory);

[[nodiscard]] ExponentialCosts exponential_costs(const ExponentialWork& work);

}  // namespace superstep
