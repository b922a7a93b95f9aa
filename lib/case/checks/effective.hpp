#pragma once
/// Effective conductivity of a packing between two fixed layers.

#include <optional>
#include <string>

#include "case/checks/field_at_state.hpp"
#include "case/scene.hpp"

namespace superstep {

struct EffectiveConductivity {
  std::optional<double> value;  ///< W/(m K) or S/m
  /// The same for a mean gradient over the whole cell, where that is periodic along the axis.
  std::optional<double> periodic;
  double flow = 0;     ///< W or A, from the higher to the lower value
  double length = 0;   ///< m, between the facing innermost centres of the two layers
  double area = 0;     ///< m^2
  std::string note;    ///< why there is no value, or why it is 0
  std::string basis;   ///< the length and the cross-section that it is for, in words
  std::string advice;  ///< to the author of the case, about the cross-section
};

/// What a steady current between two electrodes does, at the conductances of one state and with the sources
/// of its time.
struct ElectrodeFacts {
  double voltage = 0;                      ///< V, between the two fixed potentials
  double current_in = 0, current_out = 0;  ///< A, at the higher and at the lower potential
  /// Ohm; infinite when no current flows, absent where sources feed the network between the electrodes.
  std::optional<double> resistance;
  double joule_heat = 0;  ///< W, summed over the branches; without sources voltage times current
};

/// Facts of the electric field between exactly two distinct fixed potentials; nothing for other fields, and
/// where a node of capacity 0 is fed.
/// Throws nothing: a network that cannot be solved has no facts.
[[nodiscard]] std::optional<ElectrodeFacts> electrode_facts(const FieldScene& field,
                                                            const FieldAtState& state);

/// k = q L / (A dT) from a steady solve of conduction alone; 0 where no path of contacts joins the two
/// layers. Contacts across a side of the cell that the flow leads to are left out: they join the layers
/// directly. Needs a packing, exactly two distinct fixed values and no sources.
[[nodiscard]] EffectiveConductivity effective_conductivity(const Scene& scene, const FieldAtState& state);
/// The same at the start of the scene.
[[nodiscard]] EffectiveConductivity effective_conductivity(const Scene& scene, const FieldScene& field);

}  // namespace superstep
