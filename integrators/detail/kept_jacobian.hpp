#pragma once
/// Values of a Jacobian that are evaluated again only when they may have changed.

#include <span>
#include <vector>

#include "rhs/rhs.hpp"

namespace superstep {

class KeptJacobian {
 public:
  explicit KeptJacobian(Rhs& rhs) : rhs_(rhs), values_(rhs.pattern().row.size()) {}

  /// Brings the values to (t, y). Returns true when they stand as they are.
  ///   earlier_will_do  those of another state serve as well
  [[nodiscard]] bool stands_at(double t, std::span<const double> y, bool earlier_will_do = false) {
    if (version_ == rhs_.values_version() && (rhs_.traits().constant_jacobian || earlier_will_do))
      return true;
    rhs_.jacobian(t, y, values_);
    version_ = rhs_.values_version();
    return false;
  }
  /// The next values are evaluated anew.
  void forget() noexcept { version_ = 0; }
  /// On the pattern of the right-hand side [1/s].
  [[nodiscard]] const std::vector<double>& values() const noexcept { return values_; }

 private:
  Rhs& rhs_;
  std::vector<double> values_;
  std::uint64_t version_ = 0;
};

}  // namespace superstep
