#pragma once
/// Which two families of methods find the reference of a scene.

#include <string>

#include "case/scene.hpp"

namespace superstep {

struct ReferencePair {
  std::string truth;       ///< SPEC whose states are the reference
  std::string check;       ///< SPEC of another family, whose distance says how far the truth can be trusted
  bool certified = false;  ///< the truth comes with a bound of its own error, which the check must respect
};

/// Linear networks: the exponential, with its bound, checked by CVODE. Elsewhere CVODE with a tight
/// tolerance, checked by the exponential where one field drives the other alone, by an implicit or a
/// stabilised Runge-Kutta method else.
[[nodiscard]] ReferencePair reference_pair(const Scene& scene);

/// The check that goes with a reference that the user asked for.
[[nodiscard]] std::string check_of(const Scene& scene, const std::string& truth);

}  // namespace superstep
