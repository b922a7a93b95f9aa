#pragma once
/// The small problem of a shift-and-invert space.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "integrators/detail/krylov/rational_error.hpp"

namespace superstep {

/// H is what (I + gamma A)^-1 is in an orthonormal basis, from which A there is (H^-1 - I)/gamma. Keeps the
/// spectra of the last three dimensions, so that what one more vector changes can be told.
class RationalProjection {
 public:
  static constexpr std::size_t kept = 3;

  ///   pole  gamma [s]
  explicit RationalProjection(double pole = 1) : pole_(pole) {}
  /// One more basis vector: the inner products [dimension + 1] of its image with all of them, itself last.
  void add_vector(std::span<const double> products);
  [[nodiscard]] std::size_t dimension() const noexcept { return dimension_; }
  [[nodiscard]] double pole() const noexcept { return pole_; }

  /// (t phi_1(-t A)/gamma + I - exp(-t A)) e_1, and its integral over time [s].
  struct Response {
    std::vector<double> value, integral;
  };
  /// In a space with `less` vectors fewer, less < kept and < dimension.
  [[nodiscard]] Response response(double t, std::size_t less = 0) const;
  /// What the response in the whole space leaves out.
  [[nodiscard]] RationalError error(double t) const;

 private:
  struct Spectrum {
    std::vector<double> rate, vectors;  ///< eigenvalues of A [1/s]; vectors by columns
  };
  double pole_;
  std::size_t dimension_ = 0;
  std::vector<double> products_;  ///< upper triangle of H by columns
  std::array<Spectrum, kept> spectra_;
};

}  // namespace superstep
