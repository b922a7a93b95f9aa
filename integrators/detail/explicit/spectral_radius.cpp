#include "integrators/detail/explicit/spectral_radius.hpp"

#include <cmath>
#include <cstdint>

#include "rhs/lanczos.hpp"

namespace superstep {

void SpectralRadius::prepare(Rhs& rhs, std::span<const double> spans) {
  rhs_ = &rhs;
  spans_.assign(spans.begin(), spans.end());
  seen_.clear();
  if (varies() && !rhs.traits().constant_blocks) seen_.reserve(rhs.size());
  has_seen_ = false;
  blocks_ = -1;
}

bool SpectralRadius::varies() const noexcept {
  return !rhs_->traits().constant_jacobian &&
         !(rhs_->traits().constant_blocks && rhs_->facts().radiates == false);
}

bool SpectralRadius::moved(std::span<const double> y) const {
  constexpr double part = 0.01;
  const auto moved_here = [&] {
    const auto fields = rhs_->fields();
    for (std::size_t f = 0; f < fields.size(); ++f) {
      const double allowed = part * spans_[f];
      std::int64_t found = 0;  // as wide as what is compared
      for (std::size_t k = 0, i = fields[f].offset; k < fields[f].count; ++k, i += fields[f].stride)
        found |= !(std::abs(y[i] - seen_[i]) <= allowed);
      if (found != 0) return true;
    }
    return false;
  };
  return rhs_->reduction().any(moved_here());
}

double SpectralRadius::at(double t, std::span<const double> y) {
  if (rhs_->traits().constant_blocks) {
    const double beyond = rhs_->radius_beyond_blocks(t, y);
    if (blocks_ < 0) {
      const double certified = rhs_->spectral_bound(t, y) - beyond;
      blocks_ = certified > 0 && sharp_ ? estimate_spectral_radius(*rhs_).safe(certified)
                                        : std::max(0.0, certified);
    }
    return blocks_ + beyond;
  }
  constexpr double reserve = 1.03;  // for the states between one evaluation and the next
  if (!has_seen_ || moved(y)) {
    bound_ = reserve * rhs_->spectral_bound(t, y);
    seen_.assign(y.begin(), y.end());
    has_seen_ = true;
  }
  return bound_;
}

}  // namespace superstep
