#pragma once
/// What the cost of a run depends on, known before it starts.

#include <span>
#include <string>

#include "rhs/rhs.hpp"

namespace superstep {

/// What f is made of, as far as its cost and the methods for it go.
enum class Physics : char {
  linear,     ///< one field, constant coefficients
  one_way,    ///< a potential drives the temperature, coefficients are constant
  nonlinear,  ///< one field, coefficients follow it
  coupled,    ///< two fields that act on each other
};
[[nodiscard]] const char* physics_name(Physics physics) noexcept;
/// Throws std::out_of_range.
[[nodiscard]] Physics physics_of(const std::string& name);

/// Of `memory` where nobody says otherwise [bytes].
constexpr double default_memory = 0x1p30;

struct Work {
  Physics physics = Physics::linear;
  bool steady = false;  ///< a potential is solved for at every state
  bool smooth = true;   ///< no law bends
  /// Exchanges are so much faster than the run that roundings hide what is slow, and some nodes of a linear
  /// field are joined to no held value: nothing but their capacities holds them.
  bool hidden = false;
  double unknowns = 0;
  double nonzeros = 0;             ///< of the fields' matrices off their diagonals
  double t_rho = 0;                ///< time times the certified bound of the spectral radius at zero [-]
  double pieces = 1;               ///< between breakpoints of the inputs
  double shapes = 0;               ///< of inputs that change in time: each needs a Krylov space of its own
  double output_decades = 0;       ///< log10 of the last output time over the first, both from the start
  double memory = default_memory;  ///< that a basis or a factor may take [bytes]
};

///   output_times  ascending [s]; the last one is the end
[[nodiscard]] Work work_of(Rhs& rhs, double t_begin, std::span<const double> output_times,
                           double memory = default_memory);

}  // namespace superstep
