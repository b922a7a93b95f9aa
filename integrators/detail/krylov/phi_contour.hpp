#pragma once
/// The functions phi_k of a small Hessenberg matrix, k = 1 ... 5, applied to the first unit vector:
///   phi_k(Z) = 1/(2 pi i) integral e^s s^-k (s - Z)^-1 ds
/// over a contour around 0 and the spectrum of Z, which lies near the negative real axis. The trapezoidal
/// rule on Talbot's contour gains a factor of 3.89 a node. A shifted Hessenberg matrix is solved with from
/// its last row to its first, the direction in which the solution grows: no factorization, and in a band all
/// costs are linear.
/// Source: Weideman (2006), doi:10.1137/050625837; Trefethen, Weideman & Schmelzer (2006),
/// doi:10.1007/s10543-006-0077-9.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace superstep {

/// Upper Hessenberg matrix with entries in a band: row i holds columns i-1 ... i+depth-1.
class HessenbergBand {
 public:
  void prepare(std::size_t most, std::size_t depth);
  void clear() noexcept;
  [[nodiscard]] double& at(std::size_t row, std::size_t column) noexcept {
    return entry_[row * width_ + (column + 1 - row)];
  }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const noexcept {
    return entry_[row * width_ + (column + 1 - row)];
  }
  [[nodiscard]] std::size_t depth() const noexcept { return width_ - 1; }

 private:
  std::size_t width_ = 1;
  std::vector<double> entry_;
};

class PhiContour {
 public:
  static constexpr int highest = 5;

  PhiContour();
  void prepare(std::size_t most) { x_.resize(most); }
  /// Solves for the leading m by m block of h H. What follows refers to it.
  void solve(const HessenbergBand& matrix, std::size_t m, double h) noexcept;
  /// Entry number j of phi_k(h H) e_1.
  [[nodiscard]] double entry(int k, std::size_t j) const noexcept;

 private:
  static constexpr std::size_t pairs = 18;  // of conjugate nodes
  using Lanes = std::array<double, pairs>;
  struct Complex {
    Lanes re, im;
  };
  Complex node_;
  std::array<Complex, highest + 1> weight_;  ///< [k] of (s - Z)^-1
  std::array<Complex, highest + 1> scaled_;  ///< [k] weight over the pivot of the last solve
  std::vector<Complex> x_;                   ///< [m] up to a factor for each node
};

}  // namespace superstep
