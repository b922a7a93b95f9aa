#pragma once
/// Potential and temperature together, and conductivities that follow temperature:
///   C_el dV/dt = -K_el(T) V + I,   C_th dT/dt = -K_th(T) T + Q + Joule heat(V, T)
/// The state is [potential; temperature], or the temperature alone where the potential is steady or absent.
/// Source: Rojek & Nisar 2026, sections 2.4 and 7.

#include <memory>
#include <optional>
#include <vector>

#include "rhs/joule_heat.hpp"
#include "rhs/kernels/jacobian_assembly.hpp"
#include "rhs/one_way.hpp"
#include "rhs/steady_potential.hpp"

namespace superstep {

/// One field as NonlinearRhs takes it.
struct FieldInput {
  Network network;
  double pair_step = 0;           ///< s, from particle contributions only
  std::vector<KnownValue> known;  ///< values of all nodes that are not rows, by graph position
  ConductionLaws laws;            ///< of_material is never empty
  std::vector<std::int64_t> id;   ///< the user's ids by graph position, for messages; may be empty
  double low = 0, high = 0;       ///< range of initial and fixed values
  /// Where processes share the field: its rows that others have and nodes here need, and the nodes they are.
  std::shared_ptr<Halo> node_halo = nullptr;
  std::vector<std::int32_t> node_of_halo = {};
  [[nodiscard]] bool varies() const noexcept;
  [[nodiscard]] bool smooth() const noexcept;
};

struct NonlinearInput {
  FieldInput temperature;
  std::optional<FieldInput> potential;
  bool steady_potential = false;  ///< solved for, not part of the state
  double resolve_change = 1e-6;   ///< steady: relative change of a conductivity that asks for a new solve
  const Graph* joule = nullptr;   ///< electric graph whose branches heat; null = they do not
  /// [nodes] where processes share the scene: the place of a node among the slots of all of it.
  std::vector<std::int64_t> order_of_node = {};
  [[nodiscard]] Communicator* among() const noexcept { return temperature.network.among(); }
};

class NonlinearRhs final : public Rhs, public OneWayCoupling {
 public:
  explicit NonlinearRhs(NonlinearInput input);

  [[nodiscard]] double spectral_bound(double t, std::span<const double> y) override;
  [[nodiscard]] double radius_beyond_blocks(double t, std::span<const double> y) const override;
  [[nodiscard]] std::span<const double> capacities() const noexcept override { return capacity_; }
  [[nodiscard]] double inflow(double t, std::span<const double> y) override;
  [[nodiscard]] double linear_inflow(std::span<const double> v) const override;
  [[nodiscard]] std::optional<std::string> law_violation(std::span<const double> y,
                                                         double slack = 0) override;
  /// Of the temperature where it is the only field: a steady potential that heats nothing leaves it linear.
  [[nodiscard]] std::vector<InputShape> input_shapes() const override {
    return steps_potential() ? std::vector<InputShape>{} : thermal_->input_shapes();
  }
  [[nodiscard]] OneWayCoupling* one_way() override;
  void enter(double begin, double end) override;
  void leave() override;
  void ask_accuracy(double relative) override;

  // OneWayCoupling
  [[nodiscard]] Rhs& driver() override;
  [[nodiscard]] Rhs& driven() override;
  void rate(double t, std::span<const double> v, std::span<double> rate) override;
  void drive(std::span<const double> rate) override;
  [[nodiscard]] std::vector<double> steady_driver(double residual) override;

  /// Whether a potential is solved for at every state, and whether branches heat.
  [[nodiscard]] bool solves_for_potential() const noexcept { return steady_ != nullptr; }
  [[nodiscard]] bool heats() const noexcept { return joule_.has_value(); }

  /// Steady scenes: potentials on the rows of the electric network for a state (the temperatures).
  [[nodiscard]] std::span<const double> steady_potential(double t, std::span<const double> temperature);

 private:
  void do_stage(double t, const Stage& stage, std::span<double> out) override;
  void do_linear_stage(const Stage& stage, std::span<double> out) override;
  void do_block_product(std::size_t field, std::span<const double> v, std::span<double> out) override;
  void do_jacobian(double t, std::span<const double> y, std::span<double> values) override;
  [[nodiscard]] SparsePattern build_pattern() override;

  [[nodiscard]] bool varies() const noexcept { return thermal_law_ || electric_law_; }
  [[nodiscard]] bool steps_potential() const noexcept { return electric_ != nullptr; }
  [[nodiscard]] std::span<const double> temperature_of(std::span<const double> y) const noexcept {
    return y.subspan(temperature_offset_);
  }
  ///   slopes  and their slopes
  void update_conductivities(double t, const double* temperature, bool slopes = false);
  /// Conductances for the temperatures in y, for what needs them as a matrix; stages form their own.
  void update_conductances(double t, const double* temperature, bool slopes = false);
  /// Which law the rows that are here go beyond.
  [[nodiscard]] std::optional<std::string> violation_here(std::span<const double> y, double slack) const;
  /// Joule heating of the rows at (t, y) [K/s], in joule_rate_.
  void update_joule(double t, const double* y);
  template <class Add>
  void enumerate_jacobian(double t, std::span<const double> y, Add add);
  template <class Add>
  void enumerate_joule(double t, std::span<const double> y, Add& add);
  template <class Add>
  void add_of_temperature(std::size_t row, std::size_t slot, double value, Add& add) const;
  [[nodiscard]] std::span<const double> potential_on_slots(double t, const double* y);
  void mark_slots(const NonlinearInput& input);
  void sum_rows_of_jacobian(double t, std::span<const double> y);
  [[nodiscard]] double scaled_gershgorin(double t, std::span<const double> y);
  void find_facts(const NonlinearInput& input);
  void add_steady_breakpoints();
  [[nodiscard]] const FieldOperator& field_operator(std::size_t field) const noexcept;

  std::size_t temperature_offset_;
  std::vector<double> capacity_;  ///< [state]
  std::vector<std::int32_t> slot_of_node_;
  std::vector<std::int64_t> id_;                       ///< [nodes] or empty
  std::shared_ptr<FieldOperator> thermal_, electric_;  ///< electric: null unless it is part of the state
  std::optional<NodeValues> temperature_slots_, potential_slots_;
  std::optional<SlotConductivity> thermal_conductivity_, electric_conductivity_;
  std::optional<VariableConduction> thermal_law_, electric_law_;
  std::unique_ptr<SteadyPotential> steady_;
  std::optional<JouleHeat> joule_;
  std::vector<std::int32_t> row_of_potential_slot_;  ///< [slots] -1 = not a row
  std::vector<char> temperature_moves_;              ///< [slots] whether it is a row's, here or elsewhere
  std::vector<double> potential_moves_;              ///< [slots] 1 or 0, likewise of the potential
  std::vector<double> own_sum_, cross_sum_, law_sum_;
  std::vector<double> joule_rate_;                 ///< [temperature rows] K/s
  double thermal_bound_ = 0, electric_bound_ = 0;  ///< of constant conductances [1/s]
  bool radiates_ = false;
  std::unique_ptr<Rhs> driver_, driven_;
  JacobianAssembly assembly_;
};

}  // namespace superstep
