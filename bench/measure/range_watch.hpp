#pragma once
/// Whether values stay in the range that they can take: that of initial and fixed values and of surroundings,
/// widened by what sources can add.

#include <span>
#include <vector>

#include "case/scene.hpp"

namespace superstep {

/// How far a field of the right-hand side leaves that range at time t [K or V]; 0 = nowhere.
[[nodiscard]] double overshoot_at(const Scene& scene, std::size_t field, double t,
                                  std::span<const double> state);

/// Keeps the largest of a run.
class RangeWatch {
 public:
  /// Refers to the scene.
  explicit RangeWatch(const Scene& scene);
  void observe(double t, std::span<const double> state);
  [[nodiscard]] const std::vector<double>& overshoot() const noexcept { return overshoot_; }  ///< [fields]

 private:
  const Scene& scene_;
  std::vector<double> overshoot_;
};

}  // namespace superstep
