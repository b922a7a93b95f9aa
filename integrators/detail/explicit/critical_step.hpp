#pragma once
/// The critical step that explicit methods with a fixed step refer to, and the keys that choose it.

#include <vector>

#include "core/text/options.hpp"
#include "integrators/detail/explicit/spectral_radius.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

/// Keys `step`, `alpha`, `fraction`, `bound`, for methods whose step is a multiple of forward Euler's
/// critical step.
[[nodiscard]] std::vector<OptionKey> critical_step_keys();

/// Which critical step the user chose.
class CriticalStep {
 public:
  /// Throws UsageError when more than one key is given.
  explicit CriticalStep(const Options& options);
  void prepare(Rhs& rhs, std::span<const double> spans);
  /// Step [s] at (t, y); infinity for a network in which nothing limits it.
  ///   step = value | alpha * pair step without interface | fraction * 2 / radius
  [[nodiscard]] double at(double t, std::span<const double> y);
  /// Longest stable step at (t, y) [s]; infinity where the user gave the step.
  [[nodiscard]] double limit(double t, std::span<const double> y);
  /// True when the step has to follow the state.
  [[nodiscard]] bool varies() const noexcept;

 private:
  enum class Rule { step, alpha, fraction };
  Rule rule_;
  double value_;
  SpectralRadius radius_;
  Rhs* rhs_ = nullptr;
};

}  // namespace superstep
