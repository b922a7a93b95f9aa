#pragma once
/// Values of a Jacobian that are evaluated again only when they may have changed.

#include <span>
#include <vector>

#include "rhs/rhs.hpp"

namespace superstep {

class KeptJacobian {
 public:
  explicit KeptJacobian(Rhs& rhs) : rhs_(rhs), values_(rhs.own_pattern().row.size()) {}

  /// Brings the values to (t, y). Returns true when those that were there are still valid.
  ///   earlier_will_do  those of another state serve as well
  [[nodiscard]] bool bring_to(double t, std::span<const double> y, bool earlier_will_do = false) {
    if (known_ && (rhs_.traits().constant_jacobian || earlier_will_do)) return true;
    rhs_.jacobian(t, y, values_);
    known_ = true;
    return false;
  }
  /// The next values are evaluated anew.
  void forget() noexcept { known_ = false; }
  /// On the pattern of the right-hand side [1/s].
  [[nodiscard]] const std::vector<double>& values() const noexcept { return values_; }
  /// out = a v + b J v. Throws NeedsWhole where processes share the right-hand side.
  void multiply(double a, double b, std::span<const double> v, std::span<double> out) const {
    const auto& pattern = rhs_.pattern();
    for (std::size_t i = 0; i < v.size(); ++i) out[i] = a * v[i];
    for (std::size_t j = 0; j < v.size(); ++j)
      for (auto k = pattern.column_begin[j]; k < pattern.column_begin[j + 1]; ++k) {
        const auto e = static_cast<std::size_t>(k);
        out[static_cast<std::size_t>(pattern.row[e])] += b * values_[e] * v[j];
      }
  }

 private:
  Rhs& rhs_;
  std::vector<double> values_;
  bool known_ = false;
};

}  // namespace superstep
