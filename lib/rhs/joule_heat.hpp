#pragma once
/// Joule heat of the branches of an electric network, split between their ends by resistance:
///   Q_i = sum_j K_ij (V_j - V_i)^2 R_i/(R_i + R_j)       Rojek & Nisar 2026, eq. 7 and the text after it

#include <span>
#include <vector>

#include "network/graph.hpp"
#include "rhs/kernels/sliced_rows.hpp"
#include "rhs/kernels/variable_conduction.hpp"
#include "rhs/kernels/varying_sweep.hpp"

namespace superstep {

/// Rows are the temperature's rows, columns are slots.
class JouleHeat {
 public:
  ///   electric              the electric graph; branches between nodes of equal potential for ever may be
  ///   left out slot_of_node [nodes]; rows  number of temperature rows (their slots are 0 .. rows-1) capacity
  ///   [rows]       of the temperature [J/K] conductivity [slots]  for which the graph's conductances were
  ///   computed [S/m] order_of_slot [slots] in which the ends of a row are added up, where slots are not
  JouleHeat(const Graph& electric, std::span<const std::int32_t> slot_of_node, std::size_t rows,
            std::span<const double> capacity, std::span<const double> conductivity, ConductanceMean mean,
            std::span<const std::int64_t> order_of_slot = {});

  /// rate [rows] = Q_i/C_i [K/s] for potentials on the slots, with constant conductivities.
  void rate(std::span<const double> potential, std::span<double> out) const noexcept;
  /// The same with the conductivities of the moment.
  void rate(std::span<const double> potential, const SlotConductivity& conductivity,
            std::span<double> out) noexcept;
  /// Adds to `out` the sums of the rows of its derivatives, with the conductivities and slopes of the moment.
  ///   temperature_moves, potential_moves [slots]  0 or 1: whether values there may change
  void add_row_sums(std::span<const double> potential, const SlotConductivity& conductivity,
                    std::span<const char> temperature_moves, std::span<const double> potential_moves,
                    const HeatSums& out);
  /// Largest rate that potentials within `span` [V] can cause anywhere, with the reference conductivities.
  [[nodiscard]] double largest_rate(double span) const noexcept;

  /// Calls add_potential(row, slot, value) for d rate_row / d V_slot and add_temperature(row, slot, value)
  /// for d rate_row / d T_slot.
  template <class AddPotential, class AddTemperature>
  void jacobian(std::span<const double> potential, const SlotConductivity* conductivity,
                AddPotential add_potential, AddTemperature add_temperature) const;

 private:
  void pair_nodes(std::span<const double> potential, const SlotConductivity& conductivity);

  std::vector<std::int64_t> begin_;       ///< [rows+1]
  std::vector<std::int32_t> slot_;        ///< [branch ends]
  std::vector<double> geometry_;          ///< [branch ends] K/mean [m]
  std::vector<double> weight_;            ///< [branch ends] K times heat share, reference conductivities [S]
  SlicedRows sliced_weight_;              ///< the same for the sweep
  SlicedRows sliced_geometry_;            ///< of the sweep with the conductivities of the moment
  std::vector<NodePair> nodes_;           ///< [slots] for it
  std::vector<double> bend_;              ///< [slots] |ds/dT|; empty until sums of rows are asked for
  std::vector<double> inverse_capacity_;  ///< [rows]
};

template <class AddPotential, class AddTemperature>
void JouleHeat::jacobian(std::span<const double> potential, const SlotConductivity* conductivity,
                         AddPotential add_potential, AddTemperature add_temperature) const {
  for (std::size_t row = 0; row + 1 < begin_.size(); ++row)
    for (auto k = begin_[row]; k < begin_[row + 1]; ++k) {
      const auto e = static_cast<std::size_t>(k), other = static_cast<std::size_t>(slot_[e]);
      const double dv = potential[other] - potential[row], scale = inverse_capacity_[row];
      double weight = weight_[e];
      if (conductivity) {
        const double a = conductivity->value()[row], b = conductivity->value()[other];
        with_mean(conductivity->mean(), [&](auto mean) {
          weight = geometry_[e] * mean.heat(a, b);
          const double heat = scale * geometry_[e] * dv * dv;
          add_temperature(row, row, heat * mean.heat_slope_a(a, b) * conductivity->slope()[row]);
          add_temperature(row, other, heat * mean.heat_slope_b(a, b) * conductivity->slope()[other]);
        });
      }
      const double slope = 2 * scale * weight * dv;
      add_potential(row, other, slope);
      add_potential(row, row, -slope);
    }
}

}  // namespace superstep
