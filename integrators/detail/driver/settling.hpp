#pragma once
/// Finds out when a field that drives another one has become steady and need not be stepped any more.

#include <span>
#include <vector>

#include "rhs/one_way.hpp"

namespace superstep {

class Settling {
 public:
  ///   tolerance  of the spans, 0 = never;  driver_span [V], driven_span [K];  t_end  of the run [s]
  void prepare(Rhs& rhs, double tolerance, double driver_span, double driven_span, double t_end);
  void restart() noexcept { next_look_ = 0; }
  /// Whether the driver's part of y is within the tolerance of its steady state, and what it would still do
  /// to the driven field until the end of the run within that of this one. Cheap to ask at any step end.
  [[nodiscard]] bool is_steady(double t, std::span<const double> y);
  [[nodiscard]] OneWayCoupling* coupling() const noexcept { return coupling_; }
  /// What the driver tends to, once it is steady: nearer to what follows than where it stands.
  [[nodiscard]] std::span<const double> final_state() const noexcept { return final_; }

 private:
  void find_final_state(double t);
  [[nodiscard]] double heat_still_to_differ(double t, std::span<const double> now);

  OneWayCoupling* coupling_ = nullptr;
  double difference_ = 0;  // heat_still_to_differ at the last look
  double residual_ = 0, allowed_ = 0, allowed_driven_ = 0, t_end_ = 0, next_look_ = 0;
  std::vector<double> seen_;   ///< driver's state at the last look
  std::vector<double> final_;  ///< the steady one, worked out when it seems to be reached
  std::vector<double> rate_, final_rate_;
};

}  // namespace superstep
