#pragma once
/// The methods and parameter sets that the stability laboratory looks at, each as theory and as SPEC.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/lab/function.hpp"

namespace superstep {

struct MethodCase {
  std::string family, parameters, order;  ///< as in MethodStability
  int stages = 1;
  std::optional<double> beta;  ///< declared end of stability in z; none = stable everywhere
  double z_stiff = 0;          ///< step * lambda_max at which it is looked at
  double rounding = 0;         ///< that a step of a perturbation of size one may gather
  Response response;
  std::function<std::string(double step)> spec;  ///< SPEC that takes one step of that length [s]
};

/// Substeps and damping of a superstep.
struct SuperstepShape {
  int n;
  double nu;
};

/// The 15 published sets (Rojek & Nisar 2026, table 2) and two that natural order does not survive.
[[nodiscard]] std::vector<SuperstepShape> superstep_shapes(bool quick);
inline constexpr const char* superstep_orders[] = {"recurrence", "leja", "natural"};

[[nodiscard]] std::vector<MethodCase> method_catalogue(bool quick);

/// Those whose limit is measured at every frozen state: forward Euler, STS and stabilised families.
[[nodiscard]] std::vector<MethodCase> limit_catalogue(bool quick);

}  // namespace superstep
