#pragma once
/// What scenes of every kind may do without, in words.

#include <fmt/format.h>

#include "case/scene.hpp"
#include "core/text/quantity.hpp"

namespace superstep {

///   of_field  as in " of the potential" where there are several; else empty
[[nodiscard]] inline Skip fixed_nodes_skip(std::int64_t nodes, const std::string& of_field) {
  return {quantity(nodes, "fixed node") + of_field,
          nodes == 1 ? "its value is known" : "their values are known"};
}
[[nodiscard]] inline Skip order_skip(bool spheres) {
  return {"another order of the rows",
          spheres ? "spheres that touch stand near each other already" : "the case keeps that of its nodes"};
}
[[nodiscard]] inline Skip thermal_skip() {
  return {"temperature field", "the case has no [thermal]"};
}
[[nodiscard]] inline Skip search_skip() {
  return {"neighbour search and necks", "the network is given directly"};
}
[[nodiscard]] inline Skip electric_skip() {
  return {"electric field", "the case has no [electric]"};
}
[[nodiscard]] inline Skip convection_skip() {
  return {"convection", "the case has none"};
}
[[nodiscard]] inline Skip radiation_skip() {
  return {"radiation", "the case has none"};
}

}  // namespace superstep
