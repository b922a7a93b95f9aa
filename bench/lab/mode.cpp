#include "bench/lab/mode.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "bench/lab/perturbation.hpp"

namespace superstep {
namespace {

constexpr std::size_t basis_size = 40;
constexpr int most_restarts = 40;
constexpr double wanted_residual = 1e-9;  // of the rate

/// out = A v with A = -J.
void apply(Rhs& rhs, const std::vector<double>& v, std::vector<double>& out) {
  rhs.linear_stage({.y1 = v.data(), .a = 0, .d = -1}, out);
}

void subtract(std::vector<double>& w, double factor, const std::vector<double>& v) {
  for (std::size_t i = 0; i < w.size(); ++i) w[i] -= factor * v[i];
}

/// Orthonormal basis of the Krylov space of `start` and the tridiagonal matrix of A in it.
struct Krylov {
  std::vector<std::vector<double>> basis;
  std::vector<double> diagonal, off;
};

Krylov krylov_space(Rhs& rhs, const std::vector<double>& start) {
  Krylov space;
  std::vector<double> v = start, w(start.size());
  normalise(rhs, v);
  const std::size_t size = std::min(basis_size, start.size());
  while (true) {
    space.basis.push_back(v);
    apply(rhs, v, w);
    space.diagonal.push_back(capacity_product(rhs, v, w));
    for (int pass = 0; pass < 2; ++pass)  // twice is enough
      for (const auto& b : space.basis) subtract(w, capacity_product(rhs, b, w), b);
    const double next = std::sqrt(capacity_product(rhs, w, w));
    if (space.basis.size() == size || !(next > 1e-14 * std::abs(space.diagonal.back()))) return space;
    space.off.push_back(next);
    v = w;
    normalise(rhs, v);
  }
}

/// Shape of the largest Ritz value.
std::vector<double> largest_ritz_vector(const Krylov& space) {
  const auto k = static_cast<Eigen::Index>(space.diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  const Eigen::Map<const Eigen::VectorXd> diagonal(space.diagonal.data(), k), off(space.off.data(), k - 1);
  solver.computeFromTridiagonal(diagonal, off, Eigen::ComputeEigenvectors);
  std::vector<double> shape(space.basis.front().size(), 0.0);
  for (Eigen::Index j = 0; j < k; ++j)
    subtract(shape, -solver.eigenvectors()(j, k - 1), space.basis[static_cast<std::size_t>(j)]);
  return shape;
}

}  // namespace

StiffestMode stiffest_mode(Rhs& rhs) {
  StiffestMode mode;
  if (rhs.size() == 0) return mode;
  mode.shape = white_perturbation(rhs);
  std::vector<double> image(rhs.size());
  for (int restart = 0; restart < most_restarts; ++restart) {
    mode.shape = largest_ritz_vector(krylov_space(rhs, mode.shape));
    normalise(rhs, mode.shape);
    apply(rhs, mode.shape, image);
    mode.rate = capacity_product(rhs, mode.shape, image);
    subtract(image, mode.rate, mode.shape);
    mode.residual = std::sqrt(capacity_product(rhs, image, image));
    if (mode.residual <= wanted_residual * mode.rate) break;
  }
  return mode;
}

}  // namespace superstep
