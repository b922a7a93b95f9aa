#include "bench/harness/reference_pair.hpp"

#include <cmath>

#include "rhs/one_way.hpp"

namespace superstep {
namespace {

// A factorization of a cube of 93 000 nodes takes more than ten thousand sweeps.
constexpr std::size_t most_for_direct = 50'000;    // unknowns
constexpr double most_work_of_exponential = 2e10;  // sweeps times unknowns: a minute or so

/// Work of an expansion to rounding over all pieces of the inputs.
double work_of_exponential(const Scene& scene) {
  const std::vector<double> zero(scene.rhs->size(), 0.0);
  const double pieces = 1 + static_cast<double>(scene.rhs->facts().breakpoints.size());
  const double t_rho = scene.t_end * scene.rhs->spectral_bound(0, zero);
  constexpr double decades = 36;  // ln(1/rounding)
  return (std::sqrt(t_rho * pieces * decades) + pieces * decades) * static_cast<double>(scene.rhs->size());
}

bool small(const Scene& scene) {
  return scene.rhs->size() <= most_for_direct;
}

std::string tight_cvode(const Scene& scene) {
  return small(scene) ? "cvode:rtol=1e-10,linsol=klu" : "cvode:rtol=1e-8";
}

std::string tight_runge_kutta(const Scene& scene) {
  return small(scene) ? "esdirk:rtol=1e-9" : "rock:rtol=1e-8";
}

}  // namespace

bool is_one_linear_field(const Scene& scene) {
  return scene.rhs->traits().linear && scene.rhs->fields().size() == 1;
}

ReferencePair reference_pair(const Scene& scene) {
  const bool affordable = work_of_exponential(scene) <= most_work_of_exponential;
  if (is_one_linear_field(scene) && affordable)
    return {"exponential:basis=chebyshev,rtol=1e-14",
            small(scene) ? "cvode:rtol=1e-9,linsol=klu" : "cvode:rtol=1e-6", true};
  if (exactly_solvable(*scene.rhs) && affordable) return {tight_cvode(scene), "exponential:rtol=1e-12"};
  return {tight_cvode(scene), tight_runge_kutta(scene)};
}

MethodSpec check_of(const Scene& scene, const MethodSpec& truth) {
  const ReferencePair usual = reference_pair(scene);
  return truth.name() == usual.check.name() ? usual.truth : usual.check;
}

}  // namespace superstep
