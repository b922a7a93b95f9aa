#pragma once
/// What theory says about the stability of a method, for the laboratory that measures it.
/// Throughout z = step * rate >= 0 and response(z) = R(-z).

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace superstep {

/// What one step makes of a mode.
using Response = std::function<double(double z)>;

/// One parameter set of a method.
struct StabilityModel {
  std::string family, parameters;  ///< "rkc2", "s=20"
  std::string order = {};          ///< in which STS carries out its substeps, else empty
  int stages = 1;                  ///< sweeps in a step
  std::optional<double> beta;      ///< declared end of stability in z; none = stable everywhere
  double z_stiff = 0;              ///< step * lambda_max at which it is looked at
  double rounding = 0;             ///< that a step of a perturbation of size one may gather
  Response response;
  std::function<std::string(double step)> spec;  ///< SPEC that takes one step of that length [s]
};

/// Whether it is a Runge-Kutta method of many stages, from what the laboratory knows of it.
template <class Model>
[[nodiscard]] bool is_stabilised(const Model& model) {
  return model.beta.has_value() && model.order.empty() && model.stages > 1;
}

/// Methods step by a spectral radius inflated by about one per cent; so does the laboratory.
inline constexpr double stability_margin = 0.99;

/// What a method tells the laboratory, briefly or in full.
struct StabilityTheory {
  using Models = std::function<std::vector<StabilityModel>(bool quick)>;
  Models functions;  ///< to compare step by step with what is measured on the network
  Models limits;     ///< whose longest stable step is measured at every frozen state
};

}  // namespace superstep
