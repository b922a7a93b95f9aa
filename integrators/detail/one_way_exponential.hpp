#pragma once
/// Exponential integration of a scene in which the potential drives the temperature by Joule heat.
///
/// The potential is linear and propagated exactly to the Chebyshev points of a panel of time. The Joule heat
/// there, a polynomial in time, drives the temperature, which is linear as well: one Chebyshev pass a panel,
/// summed by Clenshaw's recurrence, gives its end value. Panels grow as the heat becomes smooth; once the
/// potential is steady the rest is one linear problem with a constant source.

#include <optional>
#include <vector>

#include "integrators/detail/duhamel_coefficients.hpp"
#include "integrators/detail/lanczos_propagator.hpp"
#include "integrators/detail/run_guard.hpp"
#include "integrators/detail/spectral_radius.hpp"
#include "integrators/integrator.hpp"
#include "rhs/one_way.hpp"

namespace superstep {

class OneWayExponential final : public Integrator {
 public:
  /// rtol: error at each output time relative to the span of each field, rms.
  explicit OneWayExponential(double rtol) : rtol_(rtol) {}

  void prepare(Rhs& rhs, const Plan& plan) override;
  void start(double t, std::span<const double> y) override;
  Outcome advance(double t_out) override;
  [[nodiscard]] double time() const noexcept override { return t_; }
  [[nodiscard]] std::span<const double> state() const noexcept override { return state_; }
  [[nodiscard]] const Statistics& statistics() const noexcept override { return statistics_; }

 private:
  static constexpr int degree = 8;  ///< of the heat in time, on a panel

  [[nodiscard]] std::span<double> potential() noexcept { return {state_.data(), driver_size_}; }
  [[nodiscard]] std::span<double> temperature() noexcept {
    return {state_.data() + driver_size_, driven_size_};
  }
  /// Potentials at the points of a panel of length h [degree+1], the first being the present one.
  void propagate_potential(double h);
  /// Expansion r_p of the heating rate on the panel, from the potentials at its points.
  void expand_heat(double h);
  /// Error that the truncated expansion leaves in the temperature [K].
  [[nodiscard]] double heat_error(double h) const;
  void propagate_temperature(double h);
  /// out = sum_k T_k(1 - 2 A/rho) [ state_k T + sum_p source_pk r_p ]
  void clenshaw(const DuhamelCoefficients& coefficients, std::vector<double>& out);
  void gain_inflow(double h, const DuhamelPanel& panel, std::size_t terms);
  /// True when the potential will not move any more within the tolerance.
  [[nodiscard]] bool potential_is_steady(double h);
  [[nodiscard]] Outcome advance_with_constant_heat(double t_out);

  double rtol_;
  Rhs* rhs_ = nullptr;
  OneWayCoupling* halves_ = nullptr;
  Plan plan_;
  RunGuard guard_;
  ProbeRecorder recorder_;
  std::size_t driver_size_ = 0, driven_size_ = 0, next_output_ = 0;
  double driver_radius_ = 0, driven_radius_ = 0, potential_span_ = 0, temperature_span_ = 0;
  double t_ = 0, panel_ = 0, rate_of_potential_ = 0, inflow_before_ = 0;
  bool steady_ = false, rest_begins_ = true;
  std::vector<double> state_, derivative_;
  std::vector<std::vector<double>> point_;       ///< [degree+1][driver]
  std::vector<std::vector<double>> heat_;        ///< [degree+1][driven] K/s
  std::vector<std::vector<double>> expansion_;   ///< [degree+1][driven] r_p; r_0 with constant inputs
  std::vector<double> u_, next_;                 ///< [driver]
  std::vector<double> y1_, y2_, constant_rate_;  ///< [driven]
  std::optional<LanczosPropagator> rest_;        ///< of the temperature, once the potential is steady
  Statistics statistics_;
};

}  // namespace superstep
