#pragma once
/// Conductances that follow the temperatures of their ends: K_ij = G_ij mean(kappa(T_i), kappa(T_j)).

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "rhs/conductance_mean.hpp"
#include "rhs/conductivity_law.hpp"
#include "rhs/kernels/field_operator.hpp"
#include "rhs/kernels/node_values.hpp"
#include "rhs/kernels/varying_bound.hpp"

namespace superstep {

/// What makes a field's conductances vary.
struct ConductionLaws {
  std::vector<ConductivityLaw> of_material;
  std::vector<std::int32_t> material;  ///< [graph nodes] index into of_material
  ConductanceMean mean = ConductanceMean::harmonic;

  [[nodiscard]] const ConductivityLaw& of_node(std::int32_t node) const noexcept {
    return of_material[static_cast<std::size_t>(material[static_cast<std::size_t>(node)])];
  }
};

/// The conductivities of all slots at some temperatures, with their derivatives.
class SlotConductivity {
 public:
  ///   node_of_slot [slots]  position in the graph
  SlotConductivity(ConductionLaws laws, std::vector<std::int32_t> node_of_slot);
  void update(std::span<const double> temperature);
  void update_slopes(std::span<const double> temperature);
  [[nodiscard]] std::span<const double> value() const noexcept { return value_; }
  [[nodiscard]] std::span<const double> slope() const noexcept { return slope_; }
  [[nodiscard]] ConductanceMean mean() const noexcept { return laws_.mean; }
  /// First of the slots 0, 1, ... whose temperature is an error of its law; nothing where all laws hold. A
  /// computed temperature may leave a table by 1 % of its width: where start or fixed values are at its end,
  /// every method's error does that, and the end value holds there.
  /// Looks at none where no law is limited.
  [[nodiscard]] std::optional<std::size_t> first_outside(std::span<const double> temperature,
                                                         double slack) const noexcept;
  /// Whether some temperature is an error of some law.
  [[nodiscard]] bool limited() const noexcept { return limited_; }
  [[nodiscard]] std::int32_t node_of_slot(std::size_t slot) const noexcept { return node_of_slot_[slot]; }
  [[nodiscard]] const ConductivityLaw& law_of_slot(std::size_t slot) const noexcept {
    return laws_.of_node(node_of_slot_[slot]);
  }
  /// How far above its reference value any conductivity can rise [-], >= 1; infinity for a line.
  [[nodiscard]] double largest_rise() const noexcept;

 private:
  template <class OfLaw>
  void evaluate(std::span<const double> temperature, std::span<double> out, const OfLaw& of_law);

  ConductionLaws laws_;
  std::vector<std::int32_t> node_of_slot_;
  std::vector<double> value_, slope_;
  std::vector<std::vector<std::int32_t>> slots_of_law_;  ///< only where there are several laws
  std::vector<double> gathered_;                         ///< room for the slots of one law
  bool limited_ = false;                                 ///< any law
  // Temperatures that all laws cover.
  double inside_from_ = -std::numeric_limits<double>::infinity(),
         inside_to_ = std::numeric_limits<double>::infinity();
};

/// Keeps the conductances of a field operator up to date.
class VariableConduction {
 public:
  /// The operator's conductances must be those of the laws' reference values.
  ///   slot_of_node [graph nodes]
  VariableConduction(const FieldOperator& field, const SlotConductivity& conductivity,
                     std::span<const double> reference, std::span<const std::int32_t> slot_of_node);
  /// Sets the conductances that belong to the given conductivities.
  void apply(const SlotConductivity& conductivity, FieldOperator& field);
  /// out = stage with f of the field at (t, y1) for the given conductivities, which are not kept. One sweep.
  void stage(const SlotConductivity& conductivity, FieldOperator& field, double t, const Stage& stage,
             double* out);
  /// Sums of the rows of |df/dy| at y [rows], for conductivities and slopes that belong to it: through the
  /// values of the field [1/s], those of its neighbours alone, and through the temperatures. Without
  /// radiation.
  ///   varies [slots]  whether the temperature of a slot may move
  void row_sums(const SlotConductivity& conductivity, const FieldOperator& field,
                std::span<const double> ghost_value, std::span<const double> y, std::span<const char> varies,
                const JacobianSums& out);
  /// Calls add(row, slot, value) for d f_row / d T_slot through the conductances.
  template <class Add>
  void jacobian(const SlotConductivity& conductivity, const FieldOperator& field,
                std::span<const double> ghost_value, std::span<const double> y, Add add);

 private:
  void fetch_beyond(const FieldOperator& field, const double* y);
  void pair_nodes(const SlotConductivity& conductivity, const FieldOperator& field, const double* y);
  void update_ghosts(const SlotConductivity& conductivity, const FieldOperator& field);

  std::vector<std::int32_t> slot_of_row_;          ///< of columns beyond the own rows, too
  std::vector<std::int32_t> slot_of_ghost_edge_;   ///< -1: an ambient, whose conductance is constant
  std::vector<std::int32_t> varying_ghost_edges_;  ///< the others of them
  std::vector<double> geometry_, ghost_geometry_;
  std::vector<double> row_conductivity_, conductance_, ghost_conductance_;
  SlicedRows scaled_geometry_;   ///< G_ij/C_i as the sweep takes it
  std::vector<NodePair> nodes_;  ///< [rows and halo]
  std::vector<double> bend_;     ///< likewise; empty until sums of rows are asked for
  bool rows_are_slots_ = false;  ///< row i is slot i
  std::vector<double> beyond_;   ///< [halo] values of rows that others have
};

template <class Add>
void VariableConduction::jacobian(const SlotConductivity& conductivity, const FieldOperator& field,
                                  std::span<const double> ghost_value, std::span<const double> y, Add add) {
  fetch_beyond(field, y.data());
  const std::size_t rows = field.size();  // y may go on with another field
  const auto value = [&](std::size_t column) { return column < rows ? y[column] : beyond_[column - rows]; };
  with_mean(conductivity.mean(), [&](auto mean) {
    const auto& network = field.network();
    const auto kappa = conductivity.value(), slope = conductivity.slope();
    const auto add_branch = [&](std::size_t row, std::size_t own, std::size_t other, double geometry,
                                double difference) {
      const double factor = geometry * difference / network.capacity[row];
      add(row, own, factor * mean.slope(kappa[own], kappa[other]) * slope[own]);
      add(row, other, factor * mean.slope(kappa[other], kappa[own]) * slope[other]);
    };
    for (std::size_t i = 0; i < network.size(); ++i)
      for (auto k = network.row_begin[i]; k < network.row_begin[i + 1]; ++k) {
        const auto e = static_cast<std::size_t>(k), j = static_cast<std::size_t>(network.column[e]);
        add_branch(i, static_cast<std::size_t>(slot_of_row_[i]), static_cast<std::size_t>(slot_of_row_[j]),
                   geometry_[e], value(j) - y[i]);
      }
    for (std::size_t e = 0; e < network.ghost_edges.size(); ++e) {
      if (slot_of_ghost_edge_[e] < 0) continue;
      const auto& edge = network.ghost_edges[e];
      const auto row = static_cast<std::size_t>(edge.row);
      add_branch(row, static_cast<std::size_t>(slot_of_row_[row]),
                 static_cast<std::size_t>(slot_of_ghost_edge_[e]), ghost_geometry_[e],
                 ghost_value[static_cast<std::size_t>(edge.ghost)] - y[row]);
    }
  });
}

}  // namespace superstep
