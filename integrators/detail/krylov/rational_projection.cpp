#include "integrators/detail/krylov/rational_projection.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "integrators/detail/krylov/decay.hpp"

namespace superstep {
namespace {

/// t^2 phi_2(-t lambda), the integral of that.
double decayed_twice(double lambda, double t) {
  const double x = lambda * t;
  // Six terms of the series are exact where the closed form has lost two digits.
  if (std::abs(x) < 1e-2)
    return t * t * (1.0 / 2 - x * (1.0 / 6 - x * (1.0 / 24 - x * (1.0 / 120 - x * (1.0 / 720 - x / 5040)))));
  return (t - decayed(lambda, t)) / lambda;
}

}  // namespace

void RationalProjection::add_vector(std::span<const double> products) {
  products_.insert(products_.end(), products.begin(), products.end());
  const auto m = static_cast<Eigen::Index>(++dimension_);
  Eigen::MatrixXd h(m, m);
  const double* entry = products_.data();
  for (Eigen::Index column = 0; column < m; ++column)
    for (Eigen::Index row = 0; row <= column; ++row) h(column, row) = *entry++;  // reads the lower triangle
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(h);
  std::rotate(spectra_.begin(), spectra_.end() - 1, spectra_.end());
  auto& [rate, vectors] = spectra_.front();
  rate.clear();
  for (const double theta : solver.eigenvalues()) {
    // Between 0 and 1 but for rounding; what is infinitely fast in the space has long decayed.
    const double inside = std::clamp(theta, std::numeric_limits<double>::min(), 1.0);
    rate.push_back((1 / inside - 1) / pole_);
  }
  vectors.assign(solver.eigenvectors().data(), solver.eigenvectors().data() + m * m);
}

RationalError RationalProjection::error(double t) const {
  const auto& [rate, vectors] = spectra_.front();
  return rational_error(pole_, rate, vectors, t);
}

RationalProjection::Response RationalProjection::response(double t, std::size_t less) const {
  const auto& [rate, vectors] = spectra_[less];
  const std::size_t m = rate.size();
  Response out{std::vector<double>(m, 0.0), std::vector<double>(m, 0.0)};
  for (std::size_t k = 0; k < m; ++k) {
    const double* vector = vectors.data() + k * m;
    const double once = decayed(rate[k], t);
    const double value = vector[0] * (once / pole_ - std::expm1(-t * rate[k]));
    const double integral = vector[0] * (decayed_twice(rate[k], t) / pole_ + t - once);
    for (std::size_t j = 0; j < m; ++j) {
      out.value[j] += value * vector[j];
      out.integral[j] += integral * vector[j];
    }
  }
  return out;
}

}  // namespace superstep
