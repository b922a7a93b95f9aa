#pragma once
/// A method under the only loop over time: what runs.
///
///   prepare(rhs, plan)   analyses and allocates
///   start(t, y)          sets the state; may be called again to run anew with the same preparation
///   advance(t_out)       integrates up to t_out, exactly; called once per output time, in ascending order

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "integrators/integrator.hpp"

namespace superstep {

class Driver;

class Integrator {
 public:
  explicit Integrator(std::unique_ptr<Method> method);
  ~Integrator();
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;

  /// Throws Refused, and std::invalid_argument for a plan that says nothing sensible. `rhs` must outlive the
  /// integrator.
  void prepare(Rhs& rhs, const Plan& plan);
  /// Throws std::invalid_argument unless y has the size of the right-hand side.
  void start(double t, std::span<const double> y);
  [[nodiscard]] Outcome advance(double t_out);
  [[nodiscard]] double time() const noexcept;
  /// At the output time that was reached last.
  [[nodiscard]] std::span<const double> state() const noexcept;
  [[nodiscard]] const Statistics& statistics() const noexcept;
  [[nodiscard]] double rtol() const;
  [[nodiscard]] std::string choice() const;
  /// Time since which a driving field is not stepped any more [s]; nothing while all are.
  [[nodiscard]] std::optional<double> settled_at() const noexcept;

 private:
  std::unique_ptr<Driver> driver_;
};

}  // namespace superstep
