#pragma once
/// A field of a scene as it is at one instant: conductances of the temperatures there, inputs of that time.

#include <span>
#include <string>
#include <vector>

#include "case/scene.hpp"

namespace superstep {

struct FieldAtState {
  /// Conductances, fixed values, sources and ambients are plain numbers; there are no tables.
  Graph graph;
  std::vector<double> bare;          ///< [edges] conductances from particle contributions only
  std::vector<double> conductivity;  ///< [nodes] W/(m K) or S/m; empty for a network given directly
  /// "300 to 400 K": the temperatures that conductivities are taken at; empty where none follows them.
  std::string temperatures;

  /// Whether something other than fixed values feeds a node that is not fixed.
  [[nodiscard]] bool has_sources() const noexcept;
};

/// Conductivities [nodes] at the nodes' temperatures; without these, at the laws' reference.
[[nodiscard]] std::vector<double> conductivities_at(const FieldScene& field,
                                                    std::span<const double> temperature);
/// Makes conductances [edges] of the reference those of such conductivities.
void scale_conductances(const FieldScene& field, std::span<const double> conductivity,
                        std::span<double> conductance);
/// The field at (t, state). O(nodes + edges).
[[nodiscard]] FieldAtState field_at(const Scene& scene, const FieldScene& field, double t,
                                    std::span<const double> state);
/// The same at the start of the scene.
[[nodiscard]] FieldAtState field_at_start(const Scene& scene, const FieldScene& field);

}  // namespace superstep
