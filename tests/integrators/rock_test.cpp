/// ROCK2 and ROCK4: their polynomials against their product form, their order for nonlinear problems, their
/// roundings.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.hpp"
#include "integrators/detail/explicit/rock_finish.hpp"
#include "integrators/registry.hpp"
#include "integrators/schemes/rock_polynomial.hpp"
#include "integrators/schemes/stabilised_schemes.hpp"
#include "support/problem.hpp"
#include "support/small_system.hpp"

namespace superstep {
namespace {

using Real = long double;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// w(z) from its roots.
Real weight(const RockPolynomial& p, Real z) {
  Real out = 1;
  for (std::size_t k = 0; k < static_cast<std::size_t>(p.order / 2); ++k) {
    const Real a = p.real[k], b = p.imaginary[k];
    out *= ((z - a) * (z - a) + b * b) / (a * a + b * b);
  }
  return out;
}

/// Roots in x of the polynomial of degree s - p that is orthogonal with the weight w^2/sqrt(1 - x^2): the
/// Gauss nodes, eigenvalues of what Lanczos' method makes of the multiplication by x on many Chebyshev nodes.
RealVector orthogonal_roots(int s, const RockPolynomial& p) {
  const Eigen::Index degree = s - p.order, nodes = 2 * s + 20;
  RealVector x(nodes), start(nodes);
  for (Eigen::Index k = 0; k < nodes; ++k) {
    x[k] = std::cos(std::numbers::pi_v<Real> * static_cast<Real>(2 * k + 1) / static_cast<Real>(2 * nodes));
    start[k] = weight(p, static_cast<Real>(p.length) * (x[k] - 1) / 2);
  }
  RealMatrix basis(nodes, degree), projected = RealMatrix::Zero(degree, degree);
  basis.col(0) = start.normalized();
  for (Eigen::Index j = 0; j < degree; ++j) {
    RealVector next = x.cwiseProduct(basis.col(j));
    projected(j, j) = basis.col(j).dot(next);
    for (int round = 0; round < 2; ++round)
      next -= basis.leftCols(j + 1) * (basis.leftCols(j + 1).transpose() * next);
    if (j + 1 == degree) break;
    projected(j, j + 1) = projected(j + 1, j) = next.norm();
    basis.col(j + 1) = next.normalized();
  }
  return Eigen::SelfAdjointEigenSolver<RealMatrix>(projected, Eigen::EigenvaluesOnly).eigenvalues();
}

/// R(z) = w(z) prod (x - x_i)/(1 - x_i).
struct ProductForm {
  ProductForm(int order, int s)
      : polynomial(rock_polynomial(order, s)), roots(orthogonal_roots(s, polynomial)) {}
  [[nodiscard]] double operator()(double z) const {
    const Real x = 1 + 2 * static_cast<Real>(z) / static_cast<Real>(polynomial.length);
    Real out = weight(polynomial, z);
    for (const Real root : roots) out *= (x - root) / (1 - root);
    return static_cast<double>(out);
  }
  RockPolynomial polynomial;
  RealVector roots;
};

const StabilisedFamily& family_of(int order) {
  return order == 4 ? rock4_family() : rock2_family();
}

struct RockCase {
  int order, stages;
};
class RockStages : public ::testing::TestWithParam<RockCase> {
 protected:
  const int order_ = GetParam().order, stages_ = GetParam().stages;
};

std::vector<RockCase> cases() {
  std::vector<RockCase> out;
  for (const int s : {5, 6, 7, 9, 12, 20, 35, 60, 100}) out.push_back({4, s});
  for (const int s : {3, 4, 5, 6, 9, 12, 20, 35, 60, 100, 200}) out.push_back({2, s});
  return out;
}
INSTANTIATE_TEST_SUITE_P(Counts, RockStages, ::testing::ValuesIn(cases()), [](const auto& one) {
  return fmt::format("Order{}Stages{}", one.param.order, one.param.stages);
});

TEST_P(RockStages, SchemeIsTheProductForm) {
  const int s = stages_;
  const ProductForm product(order_, s);
  const ThreeTermScheme scheme = family_of(order_).scheme(s);
  constexpr int points = 97;  // a prime: no sampling of the ripples in step
  for (int k = 0; k <= points; ++k) {
    const double z = -scheme.beta * k / points;
    // Roundings of the recurrence, as for the other families; those of its end are multiplied by w(z).
    const double tolerance =
        1e-12 +
        16 * epsilon * (s * static_cast<double>(s) + static_cast<double>(weight(product.polynomial, z)));
    EXPECT_NEAR(stability_polynomial(scheme, z), product(z), tolerance) << z;
  }
}

TEST_P(RockStages, EngineIsTheProductForm) {
  const int s = stages_;
  const ProductForm product(order_, s);
  const double length = product.polynomial.length;
  constexpr std::size_t modes = 50;
  test::SmallSystem decays(modes, length, [&](double, std::span<const double> y, std::span<double> dydt) {
    for (std::size_t k = 0; k < modes; ++k) dydt[k] = -length * static_cast<double>(k) / (modes - 1) * y[k];
  });
  Plan plan;
  plan.output_times = {1};
  plan.ranges = {{0, 1}};
  const auto integrator = make_integrator(fmt::format("rock:order={},stages={},step=1", order_, s));
  integrator->prepare(decays, plan);
  integrator->start(0, std::vector<double>(modes, 1.0));
  ASSERT_TRUE(integrator->advance(1).ok());
  EXPECT_EQ(integrator->statistics().steps, 1u);
  EXPECT_EQ(integrator->statistics().max_stages, s);
  EXPECT_EQ(decays.counters().sweeps, static_cast<std::uint64_t>(s) + 1);  // and the next step's first
  for (std::size_t k = 0; k < modes; ++k) {
    const double z = -length * static_cast<double>(k) / (modes - 1);
    const double tolerance =
        1e-12 +
        16 * epsilon * (s * static_cast<double>(s) + static_cast<double>(weight(product.polynomial, z)));
    EXPECT_NEAR(integrator->state()[k], product(z), tolerance) << z;
  }
}

TEST_P(RockStages, IsDampedBeyondTheFirstRipple) {
  const ProductForm product(order_, stages_);
  const double length = product.polynomial.length, end = order_ == 4 ? 0.85 : 0.95;
  const double ripple = order_ == 4 ? 0.9 : 0.9501;
  EXPECT_NEAR(std::abs(product(-length)), end, 1e-9);
  const int points = 40 * stages_;
  for (int k = 0; k <= points; ++k) {
    const double z = -length * k / points;
    if (z < -1) {
      EXPECT_LT(std::abs(product(z)), ripple) << z;
    }
  }
  EXPECT_GT(std::abs(product(-1.02 * length)), 1);
}

TEST(RockScheme, MeetsAllConditionsOfItsOrder) {
  const ElementaryWeights exact = {1, 1.0 / 2, 1.0 / 3, 1.0 / 6, 1.0 / 4, 1.0 / 8, 1.0 / 12, 1.0 / 24};
  for (const int order : {2, 4})
    for (int s = rock_fewest_stages(order); s <= rock_most_stages(order); ++s) {
      const auto weights = elementary_weights(family_of(order).scheme(s));
      for (std::size_t tree = 0; tree < (order == 4 ? exact.size() : 2); ++tree)
        EXPECT_NEAR(weights[tree], exact[tree], 1e-11) << s << ' ' << tree;  // stages of rounding
    }
}

TEST(RockScheme, HasModerateCoefficients) {
  for (int s = rock_fewest_stages(4); s <= rock_most_stages(4); ++s) {
    const ThreeTermScheme scheme = rock4_family().scheme(s);
    for (const auto& row : scheme.finish->a)
      for (const double a : row) EXPECT_LT(std::abs(a), 2) << s;
    for (const double b : scheme.finish->b) EXPECT_LT(std::abs(b), 1) << s;
    for (const double c : scheme.c) {
      EXPECT_GE(c, 0) << s;
      EXPECT_LT(c, 1.07) << s;  // the fourth node of the finishing procedure lies a little beyond the step
    }
  }
}

TEST(RockScheme, IntervalGrowsWithTheSquareOfTheStages) {
  // Abdulle (2002): 0.35 s^2 with less damping; Abdulle & Medovikov (2001): 0.81 s^2 at the same
  for (const auto& [order, limit] : {std::pair{2, 0.8026}, {4, 0.347}}) {
    double before = 0;
    for (int s = rock_fewest_stages(order); s <= rock_most_stages(order); ++s) {
      const double part = family_of(order).beta(s) / (static_cast<double>(s) * s);
      EXPECT_GT(part, before) << s;
      before = part;
    }
    EXPECT_NEAR(before, limit, 1e-3);
  }
}

TEST_P(RockStages, IsOfItsOrderForANonlinearTimeDependentProblem) {
  test::SmallSystem system = test::turning_system();
  const std::vector<double> initial = {1.0, -0.4, 0.6};
  constexpr double t_end = 2;
  const auto exact = test::classical_runge_kutta(system, initial, t_end, 4000);  // 1e-13 off
  Plan plan;
  plan.output_times = {t_end};
  plan.ranges = {{-3, 3}};
  std::vector<double> errors;
  for (const int steps : {10, 20, 40}) {
    const auto integrator =
        make_integrator(fmt::format("rock:order={},stages={},step={:.17g}", order_, stages_, t_end / steps));
    integrator->prepare(system, plan);
    integrator->start(0, initial);
    ASSERT_TRUE(integrator->advance(t_end).ok());
    errors.push_back(test::rms_difference({integrator->state().begin(), integrator->state().end()}, exact));
  }
  ASSERT_GT(errors[2], 1e-10);  // far above the exact solution's own error
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), order_, 0.35);
}

TEST(Rock, ErrorFollowsTheToleranceOfANonlinearTimeDependentProblem) {
  test::SmallSystem system = test::turning_system();
  const std::vector<double> initial = {1.0, -0.4, 0.6};
  const auto exact = test::classical_runge_kutta(system, initial, 2, 4000);
  Plan plan;
  plan.output_times = {2};
  plan.ranges = {{-1, 1}};
  double before = 1;
  for (const double rtol : {1e-3, 1e-5, 1e-7}) {
    const auto integrator = make_integrator(fmt::format("rock:rtol={}", rtol));
    integrator->prepare(system, plan);
    integrator->start(0, initial);
    ASSERT_TRUE(integrator->advance(2).ok());
    const double error =
        test::rms_difference({integrator->state().begin(), integrator->state().end()}, exact);
    EXPECT_LT(error, 30 * rtol);  // local control: the global error may be some times larger
    EXPECT_LT(error, 0.1 * before);
    before = error;
  }
}

TEST(Rock, NeedsFarFewerSweepsThanRkcAtTightTolerance) {
  // Error per work is what the order is for.
  test::Problem problem(test::chain(200, 0.0, 1.0));
  const auto exact = problem.exact(2000);
  const auto rock = test::run("rock:rtol=1e-8", problem, {2000});
  const auto rkc = test::run("rkc:rtol=1e-8", problem, {2000});
  ASSERT_TRUE(rock.outcome.ok() && rkc.outcome.ok());
  EXPECT_LT(test::rms_difference(rock.states.back(), exact), test::rms_difference(rkc.states.back(), exact));
  EXPECT_LT(2 * rock.sweeps, rkc.sweeps);
}

TEST(Rock, OrderTwoNeedsFewerSweepsThanRkcAtLooseTolerance) {
  // Its interval is 0.80 s^2 long, that of RKC 0.65 s^2.
  test::Problem problem(test::chain(200, 0.0, 1.0));
  const auto exact = problem.exact(2000);
  const auto rock = test::run("rock:order=2,rtol=1e-3", problem, {2000});
  const auto rkc = test::run("rkc:rtol=1e-3", problem, {2000});
  ASSERT_TRUE(rock.outcome.ok() && rkc.outcome.ok());
  EXPECT_LT(test::rms_difference(rock.states.back(), exact), 1e-3);
  EXPECT_LT(rock.sweeps, rkc.sweeps);
}

TEST(Rock, RoundingsStayBelowTheToleranceThatLimitsItsStages) {
  // A chain in its steady state: every difference of a step is rounding. Values near one, so that they round.
  const std::size_t nodes = 400;
  Graph graph = test::chain(nodes, 1.0, 2.0);
  for (std::size_t k = 0; k < nodes; ++k)
    graph.initial[k] = 1 + static_cast<double>(k) / static_cast<double>(nodes - 1);
  test::Problem problem(graph);
  for (const int order : {2, 4})
    for (const double rtol : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const int s = family_of(order).stages_within_rounding(rtol);
      EXPECT_LE(s, rock_most_stages(order));
      const double step = 0.99 * family_of(order).beta(s) / 4;  // of a chain: spectral radius 4
      const auto result = test::run(fmt::format("rock:order={},stages={},step={:.17g}", order, s, step),
                                    problem, {50 * step});
      ASSERT_TRUE(result.outcome.ok());
      EXPECT_LT(test::rms_difference(result.states.back(), problem.initial), rtol) << order << ' ' << s;
    }
}

TEST(Rock, RoundingsOfANonlinearRightHandSideStayBelowTheToleranceToo) {
  // The same chain as a system that nobody knows to be linear: it is evaluated at states, not at changes.
  constexpr std::size_t nodes = 400;
  test::SmallSystem chain(nodes, 4, [](double, std::span<const double> y, std::span<double> dydt) {
    for (std::size_t k = 0; k < nodes; ++k) {
      const double left = k > 0 ? y[k - 1] : 1.0, right = k + 1 < nodes ? y[k + 1] : 2.0;
      dydt[k] = (left - y[k]) + (right - y[k]);
    }
  });
  std::vector<double> steady(nodes);
  for (std::size_t k = 0; k < nodes; ++k)
    steady[k] = 1 + static_cast<double>(k + 1) / static_cast<double>(nodes + 1);
  for (const int order : {2, 4})
    for (const double rtol : {1e-4, 1e-6, 1e-8, 1e-10}) {
      Plan plan;
      plan.output_times = {1e5};
      plan.ranges = {{1, 2}};
      const auto integrator = make_integrator(fmt::format("rock:order={},rtol={}", order, rtol));
      integrator->prepare(chain, plan);
      integrator->start(0, steady);
      ASSERT_TRUE(integrator->advance(1e5).ok());
      EXPECT_LT(test::rms_difference({integrator->state().begin(), integrator->state().end()}, steady),
                2 * rtol);
      EXPECT_GT(integrator->statistics().max_stages, 10);
    }
}

TEST(Rock, SaysWhichStagesItTakes) {
  const std::pair<const char*, const char*> refused[] = {{"rock:step=1,stages=4", "5 to 100"},
                                                         {"rock:step=1,stages=101", "5 to 100"},
                                                         {"rock:step=1,stages=2", "3"},
                                                         {"rock:step=1,stages=201", "200"},
                                                         {"rock:order=3", "order"}};
  for (const auto& [spec, says] : refused) {
    try {
      (void)make_integrator(spec);
      ADD_FAILURE() << spec;
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  }
  for (const char* spec :
       {"rock:step=1,stages=5", "rock:order=2,step=1,stages=3", "rock:order=2,step=1,stages=200"})
    EXPECT_NO_THROW((void)make_integrator(spec)) << spec;
}

}  // namespace
}  // namespace superstep
