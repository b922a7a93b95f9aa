#pragma once
/// Exponential integration of a scene in which the potential drives the temperature by Joule heat.
///
/// The potential is linear and propagated exactly to the Chebyshev points of a panel of time. The Joule heat
/// there, a polynomial in time, drives the temperature, which is linear as well: one Chebyshev pass a panel,
/// summed by Clenshaw's recurrence, gives its end value. Panels grow as the heat becomes smooth.

#include <vector>

#include "integrators/detail/exponential/duhamel_coefficients.hpp"
#include "integrators/integrator.hpp"
#include "rhs/one_way.hpp"

namespace superstep {

class OneWayExponential final : public Propagator {
 public:
  /// rtol: error at each output time relative to the span of each field, rms.
  explicit OneWayExponential(double rtol) : rtol_(rtol) {}

  void prepare(Rhs& rhs, const Task& task) override;
  [[nodiscard]] double rtol() const override { return rtol_; }
  void begin(double t, double end, std::span<const double> y, std::span<const Instant> instants,
             bool smooth) override;
  [[nodiscard]] Outcome advance(std::size_t k) override;
  [[nodiscard]] double time() const noexcept override { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept override { return state_; }
  [[nodiscard]] bool stops_on_the_way() const noexcept override { return true; }
  void record(ProbeHistory& history) override { record_probes(history); }
  void reset_counts() override { counts_ = {}; }
  void add_counts(Statistics& statistics) const override;

 private:
  static constexpr int degree = 8;  ///< of the heat in time, on a panel

  void record_probes(ProbeHistory& history);
  [[nodiscard]] std::span<double> potential() noexcept { return {state_.data(), driver_size_}; }
  [[nodiscard]] std::span<double> temperature() noexcept {
    return {state_.data() + driver_size_, driven_size_};
  }
  /// What fixed values, sources and surroundings do to uniform temperatures on the panel.
  void find_inputs(double h);
  /// Potentials at the points of a panel of length h [degree+1], the first being the present one.
  void propagate_potential(double h);
  void gain_potential(double h);
  /// Expansion r_p of the heating rate on the panel, from the potentials at its points.
  void expand_heat(double h);
  /// Error that the truncated expansion leaves in the temperature [K].
  [[nodiscard]] double heat_error(double h) const;
  [[nodiscard]] double input_size(double h) const;
  void propagate_temperature(double h);
  /// out = sum_k T_k(1 - 2 A/rho) [ state_k T + sum_p source_pk r_p ]
  void clenshaw(const DuhamelCoefficients& coefficients, StateVector& out);
  void gain_inflow(double h, const DuhamelPanel& panel, std::size_t terms);

  double rtol_;
  Rhs* rhs_ = nullptr;
  OneWayCoupling* halves_ = nullptr;
  const Plan* plan_ = nullptr;
  std::span<const Instant> instants_;
  std::size_t driver_size_ = 0, driven_size_ = 0;
  double driver_radius_ = 0, driven_radius_ = 0;
  double potential_span_ = 0, temperature_span_ = 0, tolerance_ = 0;  ///< [-] of the spans
  double t_ = 0, panel_ = 0;
  double offset_ = 0;  ///< of the temperatures while they are propagated [K]
  StateVector state_;
  std::vector<std::vector<double>> point_;      ///< [degree+1][driver]
  std::vector<std::vector<double>> heat_;       ///< [degree+1][driven] K/s
  std::vector<std::vector<double>> expansion_;  ///< [degree+1][driven] r_p; inputs in r_0 and r_1
  StateVector u_, next_;                        ///< [driver]
  StateVector y1_, y2_;                         ///< [driven]
  StateVector input_, input_slope_;             ///< [driven] mean and half the change of what inputs do [K/s]
  Statistics counts_;
};

}  // namespace superstep
