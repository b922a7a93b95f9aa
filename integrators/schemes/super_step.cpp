#include "integrators/schemes/super_step.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace superstep {
namespace {

long double chebyshev(int n, long double x) {
  if (std::abs(x) <= 1) return std::cos(n * std::acos(x));
  const long double size = std::cosh(n * std::acosh(std::abs(x)));
  return x < 0 && n % 2 == 1 ? -size : size;
}

}  // namespace

double superstep_length(int n, double nu) noexcept {
  const double q = std::sqrt(nu);
  // ((1+q)^2n - (1-q)^2n) / ((1+q)^2n + (1-q)^2n) = tanh(n ln((1+q)/(1-q))), which cannot overflow.
  return n / (2 * q) * std::tanh(n * (std::log1p(q) - std::log1p(-q)));
}

std::vector<double> superstep_substeps(int n, double nu) {
  std::vector<double> substeps;
  for (int j = 1; j <= n; ++j)
    substeps.push_back(1 / ((nu - 1) * std::cos((2 * j - 1) * std::numbers::pi / (2 * n)) + 1 + nu));
  return substeps;
}

std::vector<double> leja_ordered(std::vector<double> substeps) {
  // Largest node first, then always the node whose product of distances to those already taken is largest.
  std::vector<double> log_distance(substeps.size(), 0.0);
  std::size_t best = substeps.size() - 1;  // the shortest substep has the largest node
  for (std::size_t taken = 0; taken < substeps.size(); ++taken) {
    std::swap(substeps[taken], substeps[best]);
    std::swap(log_distance[taken], log_distance[best]);
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = taken + 1; k < substeps.size(); ++k) {
      log_distance[k] += std::log(std::abs(1 / substeps[k] - 1 / substeps[taken]));
      if (log_distance[k] > largest) {
        largest = log_distance[k];
        best = k;
      }
    }
  }
  return substeps;
}

long double superstep_response(int n, double nu, long double x) {
  const long double damping = nu;
  return chebyshev(n, (1 + damping - x) / (1 - damping)) / chebyshev(n, (1 + damping) / (1 - damping));
}

std::vector<SuperstepShape> superstep_shapes(bool quick) {
  if (quick) return {{5, 1e-3}, {20, 1e-4}, {64, 0.05}, {128, 1e-3}};
  std::vector<SuperstepShape> shapes;
  for (const double nu : {1e-3, 1e-4, 1e-5})
    for (const int n : {5, 10, 15, 20, 25}) shapes.push_back({n, nu});
  shapes.push_back({64, 0.05});
  shapes.push_back({128, 1e-3});
  return shapes;
}

}  // namespace superstep
