#pragma once
/// Largest eigenvalue of an operator that is self-adjoint in the capacity inner product, by Lanczos.

#include <functional>
#include <span>

#include "rhs/rhs.hpp"

namespace superstep {

struct SpectralEstimate {
  double largest = 0;   ///< largest Ritz value; approaches the eigenvalue from below
  double residual = 0;  ///< of its Ritz vector, same unit
  int products = 0;     ///< operator applications spent
  /// Value to use where too small a radius means growth: 1 to 2.1 % above the Ritz value, at most
  /// `certified`.
  [[nodiscard]] double safe(double certified) const noexcept;
};

struct LanczosLimits {
  double tolerance = 5e-4;  ///< stop when the residual is below this part of the Ritz value
  int fewest = 20, most = 200;
};

/// out = operator * v
using Operator = std::function<void(std::span<const double> v, std::span<double> out)>;

/// Largest eigenvalue of `apply`. The start vector is fixed, so results repeat.
[[nodiscard]] SpectralEstimate largest_eigenvalue(const Operator& apply, std::span<const double> capacity,
                                                  const LanczosLimits& limits = {});

/// The same where the entries are rows that several processes share.
///   first_row  the one that comes first here
[[nodiscard]] SpectralEstimate largest_eigenvalue(const Operator& apply, std::span<const double> capacity,
                                                  const Reduction& reduction, std::size_t first_row,
                                                  const LanczosLimits& limits);

/// Spectral radius of the constant blocks of J [1/s], the largest among the fields; one
/// sweep a product.
[[nodiscard]] SpectralEstimate estimate_spectral_radius(Rhs& rhs, const LanczosLimits& limits = {});

}  // namespace superstep
