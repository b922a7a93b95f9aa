#pragma once
/// The potential of a steady electric field, solved for instead of stepped: K(T) V = I.

#include <memory>
#include <optional>
#include <vector>

#include "network/spd_solver.hpp"
#include "rhs/kernels/node_values.hpp"
#include "rhs/kernels/variable_conduction.hpp"

namespace superstep {

/// V depends linearly on what drives it: one basis solution for everything constant, and one for each table
/// of time. With conductivities that follow temperature the basis is solved for again once any of them has
/// moved by more than `resolve_change` since the last solve.
class SteadyPotential {
 public:
  /// Every component of the network must be held by a fixed value. Throws NumericalError.
  ///   laws, reference, slot_of_node  when conductivities vary: see VariableConduction
  SteadyPotential(Network network, NodeValues values);
  void vary(const SlotConductivity& conductivity, std::span<const double> reference,
            std::span<const std::int32_t> slot_of_node, double resolve_change);

  /// Potentials on the slots at time t; `conductivity` of the moment, or null when it is constant.
  [[nodiscard]] std::span<const double> on_slots(double t, const SlotConductivity* conductivity);
  /// Potentials on the rows at time t [rows].
  [[nodiscard]] std::span<const double> on_rows(double t, const SlotConductivity* conductivity);
  /// Largest relative change of a conductivity that is not worth a solve; never above what was stated.
  void ask_accuracy(double relative) noexcept;
  /// See Rhs::enter and Rhs::leave.
  void enter(double begin, double end) noexcept;
  void leave() noexcept;
  [[nodiscard]] const std::vector<TimeTable>& tables() const noexcept { return field_.inputs().tables(); }
  [[nodiscard]] std::uint64_t solves() const noexcept { return solves_; }

 private:
  void solve_basis();
  [[nodiscard]] bool moved(const SlotConductivity& conductivity) const noexcept;

  FieldOperator field_;
  NodeValues values_;
  SpdSolver solver_;
  std::optional<VariableConduction> variable_;
  double stated_change_ = 0, resolve_change_ = 0;
  std::vector<double> solved_for_;          ///< [slots] conductivities of the last solve
  std::vector<std::vector<double>> basis_;  ///< [1 + tables][rows]
  std::vector<double> potential_;           ///< [rows]
  double t_ = 0;
  bool is_current_ = false;
  std::uint64_t solves_ = 0;
};

}  // namespace superstep
