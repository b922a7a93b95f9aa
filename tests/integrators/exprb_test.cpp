/// What exponential Rosenbrock steps are made of: functions of small matrices, Krylov spaces, and the order
/// at steps far beyond the stiff scale.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "integrators/detail/krylov/krylov_space.hpp"
#include "integrators/registry.hpp"
#include "support/problem.hpp"
#include "support/thermoelectric.hpp"

namespace superstep {
namespace {

/// phi_k(Z) for k = 0 ... 5 by Taylor series after halving, and phi_k(2Z) from phi_k(Z):
///   phi_k(2Z) = 2^-k (phi_0(Z) phi_k(Z) + sum_j phi_j(Z)/(k-j)!)
std::vector<Eigen::MatrixXd> dense_phi(const Eigen::MatrixXd& z) {
  constexpr int highest = PhiContour::highest, terms = 30;
  const int halvings = std::max(0, static_cast<int>(std::ceil(std::log2(z.norm() + 1e-300))) + 2);
  const Eigen::MatrixXd small = z / std::ldexp(1.0, halvings),
                        one = Eigen::MatrixXd::Identity(z.rows(), z.cols());
  std::vector<Eigen::MatrixXd> phi;
  for (int k = 0; k <= highest; ++k) {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(z.rows(), z.cols()), power = one;
    for (int n = 0; n < terms; ++n, power = power * small) sum += power / std::tgamma(n + k + 1);
    phi.push_back(sum);
  }
  for (int h = 0; h < halvings; ++h) {
    const auto before = phi;
    for (int k = 0; k <= highest; ++k) {
      phi[static_cast<std::size_t>(k)] = before[0] * before[static_cast<std::size_t>(k)];
      for (int j = 1; j <= k; ++j)
        phi[static_cast<std::size_t>(k)] += before[static_cast<std::size_t>(j)] / std::tgamma(k - j + 1);
      phi[static_cast<std::size_t>(k)] /= std::ldexp(1.0, k);
    }
  }
  return phi;
}

TEST(PhiContour, OfANumberHasItsClosedForm) {
  for (const double z : {0.0, -1e-8, -0.3, -5.0, -80.0, -1e4, -1e8, 0.5}) {
    HessenbergBand matrix;
    matrix.prepare(1, 2);
    matrix.at(0, 0) = z;
    PhiContour contour;
    contour.prepare(1);
    contour.solve(matrix, 1, 1.0);
    const double first = z == 0 ? 1 : std::expm1(z) / z;
    EXPECT_NEAR(contour.entry(0, 0), std::exp(z), 1e-12) << z;
    EXPECT_NEAR(contour.entry(1, 0), first, 1e-12) << z;
    if (std::abs(z) < 0.1) continue;  // the closed forms cancel
    EXPECT_NEAR(contour.entry(2, 0), (first - 1) / z, 1e-12) << z;
    EXPECT_NEAR(contour.entry(3, 0), ((first - 1) / z - 0.5) / z, 1e-12) << z;
  }
}

TEST(PhiContour, OfAHessenbergMatrixIsThatOfItsSeries) {
  constexpr int n = 9;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const std::size_t depth : {std::size_t{2}, std::size_t{5}, std::size_t{9}}) {
    HessenbergBand matrix;
    matrix.prepare(n, depth);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = std::max(0, i - 1); j < std::min(n, i + static_cast<int>(depth)); ++j) {
        // Nearly symmetric and negative definite in its first two diagonals, anything beyond.
        const double value = i == j       ? -2 - uniform(random)
                             : j < i      ? 1
                             : j == i + 1 ? 0.9
                                          : 0.3 * uniform(random);
        dense(i, j) = matrix.at(static_cast<std::size_t>(i), static_cast<std::size_t>(j)) = value;
      }
    PhiContour contour;
    contour.prepare(n);
    for (const double h : {0.01, 1.0, 20.0}) {
      contour.solve(matrix, n, h);
      const auto phi = dense_phi(h * dense);
      for (int k = 1; k <= PhiContour::highest; ++k)
        for (int j = 0; j < n; ++j)
          EXPECT_NEAR(contour.entry(k, static_cast<std::size_t>(j)), phi[static_cast<std::size_t>(k)](j, 0),
                      1e-12)
              << depth << ' ' << h << ' ' << k << ' ' << j;
    }
  }
}

/// Of a two-way coupled scene, whose Jacobian is far from symmetric.
TEST(KrylovSpace, ErrsLessThanItSays) {
  using Kind = ConductivityLaw::Kind;
  const ConductivityLaw line{.kind = Kind::linear, .value = 2, .coefficient = -0.3, .reference = 0.2};
  const ConductivityLaw rise{
      .kind = Kind::sigmoid, .value = 1, .reference = 0.4, .amplitude = 2, .steepness = 5};
  const auto rhs =
      test::Thermoelectric{.nodes = 60, .thermal = {line, rise}, .electric = {rise, line}}.build();
  const std::size_t n = rhs->size();
  std::vector<double> y(n), f(n);
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (double& value : y) value = uniform(random);
  (*rhs)(0, y, f);

  std::vector<double> values(rhs->pattern().row.size());
  rhs->jacobian(0, y, values);
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t j = 0; j < n; ++j)
    for (auto k = rhs->pattern().column_begin[j]; k < rhs->pattern().column_begin[j + 1]; ++k)
      jacobian(rhs->pattern().row[static_cast<std::size_t>(k)], static_cast<Eigen::Index>(j)) =
          values[static_cast<std::size_t>(k)];
  Task task;
  task.allowed = {1e-3, 1e-3};
  ScaledJacobian scaled;
  scaled.prepare(*rhs, task);
  scaled.set(0, y);
  ErrorNorm norm;
  norm.prepare(*rhs, task.allowed);
  const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(f.data(), size);
  for (const std::size_t depth : {8, 120})  // two vectors back are for one field
    for (const double h : {0.05, 1.0}) {
      const auto phi = dense_phi(h * jacobian);
      for (const int k : {1, 2, 4})
        for (const double allowed : {1.0, 1e-4}) {
          KrylovSpace space;
          space.prepare(*rhs, norm, scaled, n, depth);
          space.begin([&](std::size_t i) { return f[i]; });
          ASSERT_TRUE(space.reach(h, k, allowed)) << depth << ' ' << h << ' ' << k;
          const Eigen::VectorXd exact = h * (phi[static_cast<std::size_t>(k)] * b);
          std::vector<double> error(n);
          const std::array term = {KrylovSpace::Term{h, k, 1}};
          space.combine(term, [&](std::size_t i, double value) {
            error[i] = value - exact[static_cast<Eigen::Index>(i)];
          });
          // The bound is one of a contractive network; this one grows a little across its fields.
          EXPECT_LE(norm.of([&](std::size_t i) { return error[i]; }), 2 * allowed)
              << depth << ' ' << h << ' ' << k << ' ' << allowed;
          EXPECT_LT(space.products(), n) << depth << ' ' << h << ' ' << k;
        }
    }
}

/// A stiff radiating network: the order holds at steps hundreds of times longer than the fastest scale.
TEST(ExponentialRosenbrock, KeepsItsOrderOnAStiffScene) {
  Graph graph = test::random_graph({.nodes = 60, .seed = 7, .contrast = 1e5, .fixed = 2});
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (!graph.is_fixed[node]) graph.radiation.push_back({static_cast<std::int32_t>(node), 2.0, 0.5, -1});
  test::Problem problem(graph);
  ASSERT_GT(problem.rhs->spectral_bound(0, problem.initial), 1e5);
  // From where the fastest modes of a rough start have gone: orders are those of smooth solutions.
  problem.initial = test::run("esdirk:rtol=1e-12", problem, {0.01}).states.back();
  constexpr double end = 0.05;  // the network is on its way still
  const auto truth = test::run("esdirk:rtol=1e-12", problem, {end});
  ASSERT_TRUE(truth.outcome.ok());
  std::vector<double> errors;
  for (const char* spec : {"exprb:step=0.025", "exprb:step=0.0125", "exprb:step=0.00625"}) {
    const auto result = test::run(spec, problem, {end});
    ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
    errors.push_back(test::rms_difference(result.states.back(), truth.states.back()));
  }
  SCOPED_TRACE(fmt::format("{:.3g} {:.3g} {:.3g}", errors[0], errors[1], errors[2]));
  ASSERT_GT(errors.back(), 1e-11);  // of the truth
  EXPECT_GT(std::log2(errors[1] / errors[2]), 3.7);
}

}  // namespace
}  // namespace superstep
