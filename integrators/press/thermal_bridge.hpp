#pragma once
/// Any registered integrator for the temperatures of the network that stands between two contact updates.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "dynamics/moving_network.hpp"
#include "integrators/integrator.hpp"

namespace superstep::dynamics {

class ThermalBridge {
 public:
  /// spec: an integrator of the registry, e.g. "rkc:rtol=1e-6". Throws UsageError.
  explicit ThermalBridge(std::string spec);

  /// Advances the temperatures of all particles that are not held by h [s] over the frozen network. Those of
  /// held particles are set to their wall's.
  [[nodiscard]] Outcome advance(const MovingNetwork& network, double h, std::span<double> temperature);

  [[nodiscard]] const std::string& spec() const noexcept { return spec_; }
  [[nodiscard]] std::uint64_t sweeps() const noexcept { return sweeps_; }
  [[nodiscard]] std::uint64_t steps() const noexcept { return steps_; }
  [[nodiscard]] std::uint64_t rejected() const noexcept { return rejected_; }
  [[nodiscard]] int max_stages() const noexcept { return max_stages_; }
  [[nodiscard]] double cpu_building() const noexcept { return cpu_building_; }  ///< of the networks [s]
  [[nodiscard]] double cpu_stepping() const noexcept { return cpu_stepping_; }  ///< preparation included [s]

 private:
  std::string spec_;
  std::uint64_t sweeps_ = 0, steps_ = 0, rejected_ = 0;
  int max_stages_ = 0;
  double cpu_building_ = 0, cpu_stepping_ = 0;
  std::vector<double> free_;
};

}  // namespace superstep::dynamics
