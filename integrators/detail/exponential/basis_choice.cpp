#include "integrators/detail/exponential/basis_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "integrators/costs/models.hpp"

namespace superstep {

BasisChoice choose_basis(const Work& work, double rtol) {
  struct Basis {
    const char* name;
    Family family;
    double sweeps = 0;
  };
  std::array bases = {Basis{"lanczos", Family::lanczos}, Basis{"chebyshev", Family::chebyshev},
                      Basis{"shift-invert", Family::shift_invert}};
  const CostConstants& constants = fitted_constants();
  for (auto& basis : bases)
    basis.sweeps = cautious_seconds(basis.family, work, rtol, constants) / sweep_seconds(work, constants);
  std::stable_sort(bases.begin(), bases.end(),
                   [](const Basis& a, const Basis& b) { return a.sweeps < b.sweeps; });
  std::string reason =
      fmt::format("{}, because it costs the work of about {:.0f} sweeps", bases[0].name, bases[0].sweeps);
  for (std::size_t k = 1; k < bases.size(); ++k) {
    const char* joint = k == 1 ? ";" : ",";
    if (std::isinf(bases[k].sweeps))
      reason += fmt::format("{} {} is not for this scene or tolerance", joint, bases[k].name);
    else
      reason += fmt::format("{} {} would cost {:.0f}", joint, bases[k].name, bases[k].sweeps);
  }
  return {bases[0].name, std::move(reason)};
}

}  // namespace superstep
