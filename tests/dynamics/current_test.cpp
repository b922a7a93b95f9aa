#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "dynamics/moving_network.hpp"
#include "dynamics/weighted_laplacian.hpp"
#include "press.hpp"

namespace superstep {
namespace {

using namespace test;

/// Straight from the definition, with a dense matrix.
std::vector<double> dense_solution(const std::vector<WeightedEdge>& edges, const std::vector<char>& fixed,
                                   std::vector<double> x, const std::vector<char>& reached) {
  const auto n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (const auto& edge : edges) {
    matrix(edge.i, edge.i) += edge.weight;
    matrix(edge.j, edge.j) += edge.weight;
    matrix(edge.i, edge.j) -= edge.weight;
    matrix(edge.j, edge.i) -= edge.weight;
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!fixed[k] && reached[k]) continue;
    matrix.row(i).setZero();
    matrix(i, i) = 1;
    right(i) = fixed[k] ? x[k] : 0;
  }
  const Eigen::VectorXd solution = matrix.partialPivLu().solve(right);
  return {solution.data(), solution.data() + n};
}

TEST(WeightedLaplacian, EverySolverAgreesWithTheDenseOne) {
  Random random(4);
  std::vector<WeightedEdge> edges;
  constexpr std::int32_t n = 60;
  for (std::int32_t i = 1; i < n - 5; ++i) {  // the last five are a cluster of their own
    edges.push_back({i - 1, i, random.uniform(0.1, 2)});
    if (i < 3) continue;
    const auto j = static_cast<std::int32_t>(random.below(static_cast<std::size_t>(i - 2)));
    edges.push_back({j, i, random.uniform(0.1, 2)});
  }
  for (std::int32_t i = n - 4; i < n; ++i) edges.push_back({i - 1, i, 1});
  std::vector<char> fixed(n, 0);
  std::vector<double> start(n, 0.5);
  fixed[0] = fixed[30] = 1;
  start[0] = 2;
  start[30] = -1;
  for (const auto solver : {CurrentSolver::jacobi, CurrentSolver::conjugate, CurrentSolver::direct}) {
    WeightedLaplacian laplacian(solver, 1e-13);
    std::vector<double> x = start;
    laplacian.solve(edges, fixed, x);
    const std::vector<char> reached(laplacian.reached().begin(), laplacian.reached().end());
    const auto exact = dense_solution(edges, fixed, start, reached);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_NEAR(x[i], exact[i], 1e-10)
          << "Jacobi stops at changes of 1e-13, some hundred times below its error";
    for (std::size_t i = n - 5; i < n; ++i) {
      EXPECT_FALSE(reached[i]);
      EXPECT_EQ(x[i], 0) << "no path, no current";
    }
    EXPECT_EQ(laplacian.iterations() > 0, solver != CurrentSolver::direct);
  }
}

TEST(WeightedLaplacian, DoesNotMoveASolution) {
  const std::vector<WeightedEdge> edges = {{0, 1, 1}, {1, 2, 2}};
  WeightedLaplacian laplacian(CurrentSolver::conjugate, 1e-12);
  std::vector<double> x = {0, 0, 3};
  const std::vector<char> fixed = {1, 0, 1};
  laplacian.solve(edges, fixed, x);
  EXPECT_NEAR(x[1], 2, 1e-12);
  const double before = x[1];
  laplacian.solve(edges, fixed, x);
  EXPECT_EQ(x[1], before);
}

/// A pile between electrified walls with its placement.
struct Pile {
  Pile(CurrentModel current, CurrentSolver solver, std::optional<double> low, std::optional<double> high)
      : cloud(random_cloud(140, 0.36, 21)) {
    model = quiet_model(0.4);
    model.electric.model = current;
    model.electric.solver = solver;
    model.electric.tolerance = 1e-13;  // Jacobi stops at small changes, some hundred times below its error
    model.electric.conductivity = 0.1;
    model.electric.absorption = 0.5;
    Phase phase = model.schedule.phases().front();
    phase.lower = low;
    phase.upper = high;
    model.schedule = Schedule({phase});
    cloud.add({0.39, 0.39, 0.0}, {}, 0.005);  // alone in a corner
    network = std::make_unique<MovingNetwork>(model, cloud.particles);
    network->resume(cloud.state, model.schedule.at(0));
    network->settle(cloud.state, model.schedule.at(0));
  }
  Model model;
  Cloud cloud;
  std::unique_ptr<MovingNetwork> network;
};

TEST(Current, IsThatOfTheWallsOnEveryConnectedParticle) {
  const Pile pile(CurrentModel::averaging, CurrentSolver::conjugate, 5.0, 5.0);
  const auto& J = pile.cloud.state.electric;
  ASSERT_GT(pile.network->current().connected(), 100U);
  std::size_t with_current = 0;
  for (const double value : J) {
    EXPECT_TRUE(value == 5.0 || value == 0.0);
    with_current += value == 5.0 ? 1 : 0;
  }
  EXPECT_EQ(with_current, pile.network->current().connected());
  EXPECT_EQ(J.back(), 0) << "it touches nobody";
  const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(pile.cloud.particles.radius[0], 3);
  EXPECT_NEAR(pile.network->current().heat()[0], J[0] > 0 ? 0.5 * 25 * volume / 0.1 : 0.0,
              1e-12 * volume * 125);
}

TEST(Current, SolversFindTheConstantToo) {
  // Walls that differ by one part in 1e9 keep the solvers from taking the short cut for equal walls.
  for (const auto solver : {CurrentSolver::jacobi, CurrentSolver::conjugate, CurrentSolver::direct}) {
    const Pile pile(CurrentModel::averaging, solver, 5.0, 5.0 * (1 + 1e-9));
    std::size_t with_current = 0;
    for (const double value : pile.cloud.state.electric) {
      if (value == 0) continue;
      ++with_current;
      EXPECT_NEAR(value, 5.0, 6e-9) << "between the two walls, 5e-9 apart, up to the error of the solver";
    }
    EXPECT_EQ(with_current, pile.network->current().connected());
  }
}

TEST(Current, IsTheMeanOfTheNeighbours) {
  const Pile pile(CurrentModel::averaging, CurrentSolver::conjugate, 1.0, 3.0);
  const auto& J = pile.cloud.state.electric;
  std::vector<double> weighted(J.size(), 0), area(J.size(), 0);
  for (const auto& contact : pile.network->placement().contacts) {
    const auto i = static_cast<std::size_t>(contact.i), j = static_cast<std::size_t>(contact.j);
    weighted[i] += contact.area * J[j];
    weighted[j] += contact.area * J[i];
    area[i] += contact.area;
    area[j] += contact.area;
  }
  for (const auto& contact : pile.network->placement().walls) {
    if (contact.wall != lower && contact.wall != upper) continue;
    const auto i = static_cast<std::size_t>(contact.particle);
    EXPECT_EQ(J[i], contact.wall == lower ? 1.0 : 3.0) << "takes the wall's";
    area[i] = 0;
  }
  int checked = 0;
  for (std::size_t i = 0; i < J.size(); ++i) {
    if (!(area[i] > 0) || J[i] == 0) continue;
    EXPECT_NEAR(J[i], weighted[i] / area[i], 1e-8)
        << "the solver's tolerance of 1e-10 times the contrast of areas";
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

TEST(Current, PotentialFormTurnsAllPowerIntoHeat) {
  for (const auto solver : {CurrentSolver::conjugate, CurrentSolver::direct}) {
    const Pile pile(CurrentModel::potential, solver, 0.0, 2.0);
    const auto& V = pile.cloud.state.electric;
    double inflow = 0, heat = 0;
    for (const auto& contact : pile.network->placement().walls)
      if (contact.wall == upper)
        inflow +=
            0.1 * contact.area / contact.distance * (2.0 - V[static_cast<std::size_t>(contact.particle)]);
    for (const double h : pile.network->current().heat()) heat += h;
    ASSERT_GT(inflow, 0);
    EXPECT_NEAR(heat, 0.5 * 2.0 * inflow, 1e-7 * heat) << "a U I; the solver's tolerance";
  }
}

TEST(WeightedLaplacian, WhatMeetsOnlyZeroIsZeroWhateverItWas) {
  // 0 is fixed at 0 V and holds 1 and 2; 3 is fixed at 5 V and holds nobody.
  const std::vector<WeightedEdge> edges = {{0, 1, 1e3}, {1, 2, 1e3}};
  const std::vector<char> fixed = {1, 0, 0, 1};
  for (const auto solver : {CurrentSolver::jacobi, CurrentSolver::conjugate, CurrentSolver::direct})
    for (const double left : {3.0, 1e-300}) {
      std::vector<double> x = {0, left, -left, 5};
      WeightedLaplacian laplacian(solver, 1e-10);
      laplacian.solve(edges, fixed, x);
      for (const std::size_t i : {1U, 2U}) EXPECT_NEAR(x[i], 0, 5e-10) << "1e-10 of 5 V";
    }
}

TEST(Current, NoElectrifiedWallNoCurrent) {
  const Pile pile(CurrentModel::averaging, CurrentSolver::conjugate, std::nullopt, std::nullopt);
  EXPECT_EQ(pile.network->current().connected(), 0U);
  for (const double value : pile.cloud.state.electric) EXPECT_EQ(value, 0);
  for (const double value : pile.network->current().heat()) EXPECT_EQ(value, 0);
}

TEST(Saturation, FollowsEquation50) {
  const Saturation law{.thermal = 2,
                       .thermal_slope = 0.01,
                       .temperature = 400,
                       .field = 3,
                       .field_slope = 0.1,
                       .reference_field = 5};
  EXPECT_NEAR(law.factor(500, 15), 1 + 2 / (1 + std::exp(-1.0)) + 3 / (1 + std::exp(-1.0)), 1e-15);
  EXPECT_NEAR(law.factor(400, 5), 1 + 1 + 1.5, 1e-15);
  EXPECT_EQ(Saturation{}.factor(700, 3), 1);
}

TEST(Saturation, PotentialsOfAColumnAgreeWithItsFields) {
  // A column carries one current: sigma(T, E_k) E_k A_k is the same through every contact.
  Model model = quiet_model(1);
  model.electric.model = CurrentModel::potential;
  model.electric.conductivity = 2;
  model.electric.saturation = {.thermal = 1,
                               .thermal_slope = 0.01,
                               .temperature = 500,
                               .field = 2,
                               .field_slope = 0.02,
                               .reference_field = 0};
  Phase phase = model.schedule.phases().front();
  phase.lower = 0;
  phase.upper = 100;
  phase.upper_wall_begin = phase.upper_wall = -0.47;
  model.schedule = Schedule({phase});
  Cloud cloud;
  for (int k = 0; k < 4; ++k) cloud.add({0, 0, -0.93 + 0.14 * k - 0.003 * k * k}, {}, 0.075, 300 + 100.0 * k);
  MovingNetwork network(model, cloud.particles);
  State state = cloud.state;
  network.resume(state, phase);
  network.settle(state, phase);
  double first = 0;
  for (const auto& contact : network.contacts().points()) {
    const auto i = static_cast<std::size_t>(contact.i), j = static_cast<std::size_t>(contact.j);
    const double drop = std::abs(state.electric[i] - state.electric[j]), field = drop / contact.distance;
    ASSERT_GT(drop, 1) << "current flows";
    const double sigma = model.electric.conductivity *
                         (model.electric.saturation.factor(state.temperature[i], field) +
                          model.electric.saturation.factor(state.temperature[j], field)) /
                         2;
    const double current = sigma * contact.area * field;
    if (first == 0) first = current;
    EXPECT_NEAR(current, first, 1e-8 * first) << "the turns end at 1e-10 of the largest potential";
  }
  EXPECT_GT(first, 0);
}

}  // namespace
}  // namespace superstep
