#pragma once
/// The spectral radius that explicit methods step by: sharp where it can be, certified everywhere.

#include <vector>

#include "rhs/rhs.hpp"

namespace superstep {

class SpectralRadius {
 public:
  /// sharp: Lanczos for constant blocks, inflated; else the certified bound everywhere.
  explicit SpectralRadius(bool sharp = true) : sharp_(sharp) {}
  /// What is known is forgotten; spans [fields] say what a small change of the state is.
  void prepare(Rhs& rhs, std::span<const double> spans);
  /// Upper bound of the spectral radius at (t, y) [1/s]. What follows the state is found anew once some value
  /// has moved by more than a part of its field's span; until then a reserve covers it.
  [[nodiscard]] double at(double t, std::span<const double> y);
  /// True when another state may have another radius.
  [[nodiscard]] bool varies() const noexcept;

 private:
  [[nodiscard]] bool moved(std::span<const double> y) const;

  bool sharp_;
  Rhs* rhs_ = nullptr;
  std::vector<double> spans_, seen_;
  bool has_seen_ = false;
  double blocks_ = -1, bound_ = 0;  ///< of the constant blocks, -1 = not found yet; of the state `seen_`
};

}  // namespace superstep
