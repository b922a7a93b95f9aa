#pragma once
/// Growth per step, measured: where a step length stops being stable.

#include <functional>
#include <string>
#include <vector>

#include "results/study/stability_results.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

/// A mode of a linear right-hand side: an eigenvector, of which a turning one has an imaginary part as well.
struct Mode {
  std::vector<double> real, imaginary;  ///< [n]; the second one empty where the eigenvalue is real
};

/// Where all modes are known: one step from each, and growth is the largest factor of any. That is right also
/// where the mode that limits the step is not the stiffest one, and where several grow by themselves.
/// Else steps from the stiffest mode and white noise, each followed by a product with J that nobody counts:
/// slow modes, of which every method keeps nearly all, vanish, and what is left grows exactly where a step is
/// too long. What grows by itself, at rates up to `rising`, is no fault of a step: a product with J - rising
/// takes it away, too. Growth is the mean factor per step over the later half of the steps.
class GrowthMeter {
 public:
  enum class Modes { orthogonal, real, complex };
  /// `rhs` is linear without sources; `mode` its stiffest one, or as near as is known.
  ///   rising  largest real part of an eigenvalue, 0 where none is positive [1/s]
  GrowthMeter(Rhs& rhs, std::vector<double> mode, Modes modes, double rising = 0);

  /// `modes` are all that a step may not let grow; not none.
  GrowthMeter(Rhs& rhs, std::vector<Mode> modes);

  /// Factor per step; infinite when it overflows. `spec` must take exactly one step over `step` [s]. Of
  /// orthogonal modes never below what the given one shows by itself, so that no step is called stable at
  /// which that one grows.
  [[nodiscard]] double growth(const std::string& spec, double step);
  [[nodiscard]] int runs() const noexcept { return runs_; }
  [[nodiscard]] int steps_per_run() const noexcept { return steps_; }

 private:
  [[nodiscard]] double growth_of_each(const std::string& spec, double step);

  Rhs& rhs_;
  std::vector<Mode> modes_;  // empty where not all are known
  std::vector<double> mode_, start_, image_;
  void take_slow_modes_away(std::vector<double>& e);

  bool orthogonal_ = false;
  double rising_ = 0;
  int steps_ = 1;
  int runs_ = 0;
};

/// Growth of 1 to within what the measurement tells apart.
[[nodiscard]] Tendency tendency(double growth) noexcept;

/// Longest step with growth <= 1 [s]: bisection between one that is stable and one that is not, to `width` of
/// itself. Infinite when no step grows.
///   first  where to look first, > 0 [s]
[[nodiscard]] double longest_stable_step(const std::function<double(double step)>& growth, double first,
                                         double width);

}  // namespace superstep
