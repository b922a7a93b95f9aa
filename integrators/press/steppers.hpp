#pragma once
/// The ways to take a step of the moving network.

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "integrators/press/motion.hpp"
#include "integrators/press/step_control.hpp"
#include "parallel/reduction.hpp"

namespace superstep::dynamics {

/// How far a step may exceed the limit at its end: what contacts that stand grow stiffer in it would else
/// have every other step made again.
inline constexpr double stiffening = 1.25;

/// phi rule for positions, velocities and temperatures by staggered fixed-point iteration.
///   r = r_L + h (phi v + (1 - phi) v_L),  v = v_L + h/m (phi F + (1 - phi) F_L),
///   T = T_L + h (phi q + (1 - phi) q_L)
/// Iterate 0 is the Euler predictor. Each iteration takes the motion first, with the temperatures frozen,
/// then the temperatures at the new contacts. Order 2 in time at phi = 0.5, else 1. Source: Zohdi (2014), eqs
/// 22-27, 36, 45-49, Algorithm 1.
class StaggeredStepper final : public Stepper {
 public:
  StaggeredStepper(const SteppingSettings& settings, MovingNetwork& network);
  void begin(const State& state) override;
  [[nodiscard]] Attempt attempt(State& state, const Phase& phase, double h) override;
  [[nodiscard]] double limit() const noexcept override { return limit_; }
  [[nodiscard]] double wall_force() const noexcept override { return wall_force_; }
  [[nodiscard]] const ThermalBridge* bridge() const noexcept override {
    return bridge_ ? &*bridge_ : nullptr;
  }

 private:
  void predict(const State& state, double h);
  void move(const State& state, double h);
  void heat(const State& state, double h);
  void place(const State& state, const Phase& phase, double h);
  [[nodiscard]] bool iterate(const State& state, const Phase& phase, double h, int iteration);
  [[nodiscard]] bool measure_motion(const State& state, int iteration);
  [[nodiscard]] bool measure_heat(const State& state, int iteration);
  [[nodiscard]] Outcome bridge_heat(const State& state, double h);
  [[nodiscard]] Attempt failed(const State& state, int iteration, double wanted) const;
  void blame(const State& state, Attempt& attempt) const;
  [[nodiscard]] bool steady() const noexcept {
    return settings_.control == SteppingSettings::Control::steady;
  }
  [[nodiscard]] bool leans_back() const noexcept { return settings_.phi < 0.5; }
  [[nodiscard]] double stable_limit(std::span<const double> temperature);
  [[nodiscard]] double factor(int iteration, double unknown) const;
  [[nodiscard]] double shortened() const;

  SteppingSettings settings_;
  MovingNetwork& network_;
  std::optional<ThermalBridge> bridge_;
  Reduction reduction_;
  double wall_force_ = 0, limit_ = std::numeric_limits<double>::infinity();
  double smallest_radius_;
  double travelled_ = 0;  // of the trial at hand: the longest way, in smallest radii
  std::vector<Vec3> force_, force_begin_, position_, position_before_, velocity_;
  std::vector<double> rate_, rate_begin_, temperature_, temperature_before_;
  FieldError position_error_, temperature_error_;
  double position_rounding_ = 0, temperature_rounding_ = 0;  // of sums over all particles [m], [K]
};

/// Semi-implicit Euler: v = v_L + h F_L/m, then r = r_L + h v; T by forward Euler. One evaluation of the
/// forces a step, order 1, the step a part of the stability limits, of the motion at both of its ends and of
/// the temperatures at its begin. For comparison.
class PlainStepper final : public Stepper {
 public:
  PlainStepper(const SteppingSettings& settings, MovingNetwork& network);
  void begin(const State& state) override;
  [[nodiscard]] Attempt attempt(State& state, const Phase& phase, double h) override;
  [[nodiscard]] double limit() const noexcept override { return limit_; }
  [[nodiscard]] double wall_force() const noexcept override { return wall_force_; }
  [[nodiscard]] const ThermalBridge* bridge() const noexcept override {
    return bridge_ ? &*bridge_ : nullptr;
  }

 private:
  [[nodiscard]] double shortened(double h);

  static constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
  double fraction_, smallest_radius_;
  MovingNetwork& network_;
  std::optional<ThermalBridge> bridge_;
  double limit_ = 0, wall_force_ = 0, wall_force_end_ = 0;
  std::uint64_t evaluated_ = none;  // instant of the network at which force_end_ was taken
  std::vector<Vec3> force_, force_end_, position_, velocity_;
  std::vector<double> rate_, temperature_;
};

}  // namespace superstep::dynamics
