#pragma once
/// The critical step that explicit methods with a fixed step refer to, and the keys that choose it.

#include <vector>

#include "core/options.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

/// Keys `step`, `alpha`, `fraction`, for methods whose step is a multiple of forward Euler's critical step.
[[nodiscard]] std::vector<OptionKey> critical_step_keys();

/// Which critical step the user chose.
class CriticalStep {
 public:
  /// Throws UsageError when more than one key is given.
  explicit CriticalStep(const Options& options);
  /// Step [s] for `rhs` at (t, y); infinity for a network in which nothing limits it.
  ///   step = value | alpha * pair step without interface | fraction * 2 / certified bound
  [[nodiscard]] double resolve(Rhs& rhs, double t, std::span<const double> y) const;

  /// To be asked every now and then at step ends: true when the step has to be resolved anew, because a field
  /// has settled or because conductances follow the state.
  [[nodiscard]] bool may_have_changed(Rhs& rhs, double t, std::span<const double> y) const;

 private:
  enum class Rule { step, alpha, fraction };
  Rule rule_;
  double value_;
};

}  // namespace superstep
