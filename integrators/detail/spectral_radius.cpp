#include "integrators/detail/spectral_radius.hpp"

#include "rhs/lanczos.hpp"

namespace superstep {

double SpectralRadius::at(Rhs& rhs, double t, std::span<const double> y) {
  if (!rhs.traits().constant_blocks) return rhs.spectral_bound(t, y);
  const double beyond = rhs.radius_beyond_blocks(t, y);
  if (version_ != rhs.values_version()) {
    const double certified = rhs.spectral_bound(t, y) - beyond;
    value_ = certified > 0 ? estimate_spectral_radius(rhs).safe(certified) : 0;
    version_ = rhs.values_version();
  }
  return value_ + beyond;
}

}  // namespace superstep
