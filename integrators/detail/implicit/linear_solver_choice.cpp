#include "integrators/detail/implicit/shifted_solver.hpp"

namespace superstep {

std::string fastest_linear_solver(const Rhs& rhs) {
  constexpr std::size_t pcg_pays = 400, cholmod_pays = 3000;  // unknowns
  const auto& traits = rhs.traits();
  if (traits.linear && traits.symmetric && rhs.reduction().total() >= pcg_pays) return "pcg";
  return traits.symmetric && rhs.reduction().total() >= cholmod_pays ? "cholmod" : "klu";
}

std::unique_ptr<ShiftedSolver> make_shifted_solver(const std::string& name, Rhs& rhs) {
  if (name == "pcg") return make_pcg_solver(rhs);
  if (name == "cholmod") return make_cholmod_solver(rhs);
  return make_klu_solver(rhs);
}

std::string fastest_klu_ordering(const Rhs& rhs) {
  constexpr std::size_t metis_pays = 4000;  // unknowns: 1.6 times as fast at 9680, 0.8 times at 800
  return rhs.reduction().total() >= metis_pays ? "metis" : "amd";
}

}  // namespace superstep
