#pragma once
/// Any registered method over a network that stands between two changes: a network that changes gets a new
/// stretch, not a new method.

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "integrators/driver.hpp"
#include "network/network.hpp"

namespace superstep {

class NetworkRhs;

class Stretches {
 public:
  /// spec: an integrator of the registry, e.g. "rkc:rtol=1e-6". Throws UsageError.
  explicit Stretches(std::string spec);
  ~Stretches();
  Stretches(Stretches&&) noexcept;
  Stretches& operator=(Stretches&&) noexcept;

  /// The network from now on. What was found out about the one before is forgotten.
  void take(Network network);
  /// Advances values [rows] by h [s] over the network. The same h over the same network is prepared once:
  /// again only where the span, or the range of the values, has grown by more than a twentieth.
  ///   span   what rtol refers to, > 0; 0 = that of each stretch by itself
  ///   share  part of the tolerance that this stretch may use up: errors of stretches add up, and shares that
  ///          sum to 1 leave a whole run within its tolerance. Never below a hundred roundings of the values
  /// Values are left as they were unless the outcome is ok, nor is it where `stop` was set.
  [[nodiscard]] Outcome advance(double h, std::span<double> values, double span = 0, double share = 1);

  const std::atomic<bool>* stop = nullptr;  ///< set from outside: stop at a step end of the method

  [[nodiscard]] const std::string& spec() const noexcept { return spec_; }
  /// Work of all stretches so far; see Statistics.
  [[nodiscard]] std::uint64_t sweeps() const noexcept { return sweeps_; }
  [[nodiscard]] std::uint64_t steps() const noexcept { return steps_; }
  [[nodiscard]] std::uint64_t rejected() const noexcept { return rejected_; }
  [[nodiscard]] std::uint64_t jacobians() const noexcept { return jacobians_; }
  [[nodiscard]] std::uint64_t factorizations() const noexcept { return factorizations_; }
  [[nodiscard]] std::uint64_t solves() const noexcept { return solves_; }
  [[nodiscard]] std::uint64_t preparations() const noexcept { return preparations_; }
  [[nodiscard]] int max_stages() const noexcept { return max_stages_; }
  [[nodiscard]] double cpu_building() const noexcept { return cpu_building_; }  ///< of right-hand sides [s]
  [[nodiscard]] double cpu_stepping() const noexcept { return cpu_stepping_; }  ///< preparation included [s]

 private:
  [[nodiscard]] bool is_prepared(double h, double span, double rtol, const FieldRange& range) const noexcept;
  void prepare(double h, double span, double rtol, const FieldRange& range);
  [[nodiscard]] Outcome run(double h, std::span<double> values);
  void add_sources(double h, std::span<double> values) const;

  std::string spec_;
  double rtol_ = 0;      // of the method; 0 = it has none
  double tightest_ = 0;  // that it takes
  std::unique_ptr<NetworkRhs> rhs_;
  std::unique_ptr<Integrator> integrator_;  // null = not prepared; after rhs_, which it refers to
  double h_ = 0, span_ = 0, rtol_now_ = 0;  // that it is prepared for
  FieldRange range_;
  const std::atomic<bool>* stop_ = nullptr;  // the same
  std::uint64_t sweeps_ = 0, steps_ = 0, rejected_ = 0, jacobians_ = 0, factorizations_ = 0, solves_ = 0,
                preparations_ = 0;
  int max_stages_ = 0;
  double cpu_building_ = 0, cpu_stepping_ = 0;
};

}  // namespace superstep
