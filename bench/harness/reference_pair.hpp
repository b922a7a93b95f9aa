#pragma once
/// Which two families of methods find the reference of a scene.

#include "case/scene.hpp"
#include "integrators/method_spec.hpp"

namespace superstep {

struct ReferencePair {
  MethodSpec truth;        ///< whose states are the reference
  MethodSpec check;        ///< of another family, whose distance says how far the truth can be trusted
  bool certified = false;  ///< the truth comes with a bound of its own error, which the check must respect
};

/// One linear field: the exponential, with its bound, checked by CVODE. Elsewhere CVODE with a tight
/// tolerance, checked by the exponential where one field drives the other alone, by an implicit or a
/// stabilised Runge-Kutta method else.
[[nodiscard]] ReferencePair reference_pair(const Scene& scene);

[[nodiscard]] bool is_one_linear_field(const Scene& scene);

/// The check that goes with a reference that the user asked for.
[[nodiscard]] MethodSpec check_of(const Scene& scene, const MethodSpec& truth);

}  // namespace superstep
