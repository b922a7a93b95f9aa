#pragma once
/// Any registered integrator for the temperatures of the network that stands between two contact updates.

#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "dynamics/moving_network.hpp"
#include "integrators/host/stretches.hpp"

namespace superstep::dynamics {

class ThermalBridge {
 public:
  /// spec: an integrator of the registry, e.g. "rkc:rtol=1e-6". Throws UsageError.
  explicit ThermalBridge(std::string spec) : stretches_(std::move(spec)) {}

  /// Advances the temperatures of all particles that are not held by h [s] over the frozen network. Those of
  /// held particles are set to their wall's. The method's tolerance is that of the whole schedule: each call
  /// may use up the part of it that h is of the schedule's time. It refers to the range of temperatures now,
  /// those of the walls included.
  ///   stop  set from outside: the call ends early, interrupted; may be null
  [[nodiscard]] Outcome advance(const MovingNetwork& network, double h, std::span<double> temperature,
                                const std::atomic<bool>* stop);

  [[nodiscard]] const std::string& spec() const noexcept { return stretches_.spec(); }
  [[nodiscard]] std::uint64_t sweeps() const noexcept { return stretches_.sweeps(); }
  [[nodiscard]] std::uint64_t steps() const noexcept { return stretches_.steps(); }
  [[nodiscard]] std::uint64_t rejected() const noexcept { return stretches_.rejected(); }
  [[nodiscard]] std::uint64_t jacobians() const noexcept { return stretches_.jacobians(); }
  [[nodiscard]] std::uint64_t factorizations() const noexcept { return stretches_.factorizations(); }
  [[nodiscard]] std::uint64_t solves() const noexcept { return stretches_.solves(); }
  [[nodiscard]] int max_stages() const noexcept { return stretches_.max_stages(); }
  /// Of the networks and their right-hand sides [s].
  [[nodiscard]] double cpu_building() const noexcept { return cpu_freezing_ + stretches_.cpu_building(); }
  [[nodiscard]] double cpu_stepping() const noexcept { return stretches_.cpu_stepping(); }  ///< see there

 private:
  Stretches stretches_;
  double cpu_freezing_ = 0;
  std::vector<double> free_;
};

}  // namespace superstep::dynamics
