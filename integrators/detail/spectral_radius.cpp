#include "integrators/detail/spectral_radius.hpp"

#include "rhs/lanczos.hpp"

namespace superstep {

double SpectralRadius::at(Rhs& rhs, double t, std::span<const double> y) {
  const auto& traits = rhs.traits();
  if (!traits.linear || !traits.symmetric) return rhs.spectral_bound(t, y);
  if (version_ != rhs.values_version()) {
    const double certified = rhs.spectral_bound(t, y);
    value_ = certified > 0 ? estimate_spectral_radius(rhs).safe(certified) : 0;
    version_ = rhs.values_version();
  }
  return value_;
}

}  // namespace superstep
