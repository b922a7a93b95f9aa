/// Coupled and nonlinear right-hand sides: Jacobians against differences, bounds against dense eigenvalues,
/// heat against the branches that make it.

#include "rhs/nonlinear_rhs.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "network/cg_steady.hpp"
#include "network/spd_solver.hpp"
#include "support/thermoelectric.hpp"

namespace superstep {
namespace {

using test::Thermoelectric;

struct Variant {
  std::string name;
  Thermoelectric settings;
};

std::vector<Variant> variants() {
  using Kind = ConductivityLaw::Kind;
  const ConductivityLaw constant{.value = 2};
  const ConductivityLaw line{.kind = Kind::linear, .value = 2, .coefficient = -0.3, .reference = 0.2};
  const ConductivityLaw rise{
      .kind = Kind::sigmoid, .value = 1, .reference = 0.4, .amplitude = 2, .steepness = 3};
  ConductivityLaw table{.kind = Kind::table, .value = 1};
  table.temperatures = {-2, 0.3, 2};
  table.values = {1, 2, 1.5};
  return {
      {"one_way", {}},
      {"uncoupled", {.joule_heat = false}},
      {"radiating", {.radiation = true}},
      {"convecting_in_time", {.convection = true, .tables = true}},
      {"sigma_rises", {.electric = {rise, constant}}},
      {"kappa_falls", {.thermal = {line, constant}}},
      {"two_way", {.thermal = {table, line}, .electric = {line, rise}}},
      {"pipe", {.thermal = {line, rise}, .electric = {rise, line}, .mean = ConductanceMean::arithmetic}},
      {"everything",
       {.thermal = {table, line},
        .electric = {line, rise},
        .convection = true,
        .radiation = true,
        .tables = true}},
      {"kappa_alone", {.potential = false, .thermal = {line, rise}}},
      {"steady_one_way", {.steady = true, .tables = true}},
  };
}

class EveryVariant : public ::testing::TestWithParam<Variant> {};

INSTANTIATE_TEST_SUITE_P(Nonlinear, EveryVariant, ::testing::ValuesIn(variants()),
                         [](const auto& variant) { return variant.param.name; });

std::vector<double> some_state(std::size_t n) {
  std::vector<double> y(n);
  for (std::size_t i = 0; i < n; ++i) y[i] = 0.5 + 0.4 * std::sin(1.7 * static_cast<double>(i));
  return y;
}

Eigen::MatrixXd dense_jacobian(Rhs& rhs, double t, std::span<const double> y) {
  const auto& pattern = rhs.pattern();
  std::vector<double> values(pattern.row.size());
  rhs.jacobian(t, y, values);
  const auto n = static_cast<Eigen::Index>(rhs.size());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (auto k = pattern.column_begin[static_cast<std::size_t>(j)];
         k < pattern.column_begin[static_cast<std::size_t>(j) + 1]; ++k)
      out(pattern.row[static_cast<std::size_t>(k)], j) = values[static_cast<std::size_t>(k)];
  return out;
}

TEST_P(EveryVariant, JacobianIsTheDerivative) {
  const auto rhs = GetParam().settings.build();
  auto y = some_state(rhs->size());
  const double t = 0.37;
  const auto jacobian = dense_jacobian(*rhs, t, y);
  constexpr double change = 1e-6;
  std::vector<double> above(y.size()), below(y.size());
  for (std::size_t j = 0; j < y.size(); ++j) {
    const double kept = y[j];
    y[j] = kept + change;
    (*rhs)(t, y, above);
    y[j] = kept - change;
    (*rhs)(t, y, below);
    y[j] = kept;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double slope = (above[i] - below[i]) / (2 * change);
      // Central differences: rounding epsilon/change and a third derivative times change^2.
      EXPECT_NEAR(jacobian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)), slope,
                  1e-8 * jacobian.cwiseAbs().maxCoeff())
          << i << ' ' << j;
    }
  }
}

TEST_P(EveryVariant, BoundHoldsTheSpectrum) {
  const auto rhs = GetParam().settings.build();
  const auto y = some_state(rhs->size());
  const auto jacobian = dense_jacobian(*rhs, 0.37, y);
  const double radius = jacobian.eigenvalues().cwiseAbs().maxCoeff();
  const double bound = rhs->spectral_bound(0.37, y);
  EXPECT_GE(bound, radius * (1 - 1e-12));
  EXPECT_LE(bound, 4 * radius);  // of use: within the factor that row sums lose
}

/// Largest row sums of |J| within the fields and across them.
struct RowSums {
  double own = 0, to_temperature = 0, to_potential = 0;
};

RowSums row_sums(const Eigen::MatrixXd& jacobian, Eigen::Index potentials) {
  const auto temperatures = jacobian.rows() - potentials;
  const auto largest = [](const auto& block) { return block.cwiseAbs().rowwise().sum().maxCoeff(); };
  return {std::max(largest(jacobian.topLeftCorner(potentials, potentials)),
                   largest(jacobian.bottomRightCorner(temperatures, temperatures))),
          largest(jacobian.topRightCorner(potentials, temperatures)),
          largest(jacobian.bottomLeftCorner(temperatures, potentials))};
}

TEST(ScaledGershgorin, IsTightForCrossTermsOfAnySize) {
  // A sigmoid 1 to 2000 widths above the temperatures, in either field's favour (the sign of c - a), and
  // potentials from 1e-150 to 1e100 V: cross terms from 1e-320 (denormal) to 1e100.
  for (const double reference : {1.0, 30.0, 300.0, 700.0, 740.0, 2000.0})
    for (const double thermal : {1e-3, 1e3})
      for (const double volts : {1e-150, 1.0, 1e100}) {
        const ConductivityLaw rise{.kind = ConductivityLaw::Kind::sigmoid,
                                   .value = 1,
                                   .reference = reference,
                                   .amplitude = 2,
                                   .steepness = 1};
        const auto rhs = Thermoelectric{
            .thermal = {{.value = thermal}, {.value = thermal}},
            .electric = {
                rise, rise}}.build();
        auto y = some_state(rhs->size());
        const auto potentials = rhs->fields()[0].count;
        for (std::size_t i = 0; i < potentials; ++i) y[i] *= volts;
        const auto jacobian = dense_jacobian(*rhs, 0, y);
        const auto sums = row_sums(jacobian, static_cast<Eigen::Index>(potentials));
        const double bound = rhs->spectral_bound(0, y);
        const std::string where = fmt::format("{} {} {}", reference, thermal, volts);
        EXPECT_GE(bound, sums.own * (1 - 1e-12)) << where;
        // At its best scaling the bound exceeds the larger block by the geometric mean of the cross terms at
        // most. Terms of either sign that meet in one place are summed by magnitude: some 1e-4 of the blocks
        // where the law moves, nothing far below it, and a factor 2 is allowed across them.
        const double meeting = reference < 700 ? 1e-2 : 1e-12;
        EXPECT_LE(bound, sums.own * (1 + meeting) +
                             2 * std::sqrt(sums.to_temperature) * std::sqrt(sums.to_potential))
            << where;
        if (volts == 1) {
          const double radius = jacobian.eigenvalues().cwiseAbs().maxCoeff();
          EXPECT_GE(bound, radius * (1 - 1e-12)) << where;
        }
      }
}

TEST_P(EveryVariant, InflowIsTheSumOfCapacityTimesRate) {
  const auto rhs = GetParam().settings.build();
  const auto y = some_state(rhs->size());
  std::vector<double> rate(y.size());
  (*rhs)(0.37, y, rate);
  const auto& field = rhs->fields().back();
  ASSERT_EQ(field.name, "temperature");
  double sum = 0, scale = 0;
  for (std::size_t i = field.offset; i < field.offset + field.count; ++i) {
    sum += rhs->capacities()[i] * rate[i];
    scale += std::abs(rhs->capacities()[i] * rate[i]);
  }
  EXPECT_NEAR(rhs->inflow(0.37, y), sum, 1e-12 * scale);
}

TEST_P(EveryVariant, StageIsTheCombinationItSays) {
  const auto rhs = GetParam().settings.build();
  const std::size_t n = rhs->size();
  const auto y1 = some_state(n);
  std::vector<double> y2(n, 0.3), y0(n, -0.2), f0(n, 0.7), rate(n), out(n);
  (*rhs)(0.37, y1, rate);
  rhs->stage(0.37,
             {.y1 = y1.data(),
              .a = 1.5,
              .d = 0.01,
              .y2 = y2.data(),
              .b = -0.4,
              .y0 = y0.data(),
              .c = 0.2,
              .f0 = f0.data(),
              .e = 0.03},
             out);
  for (std::size_t i = 0; i < n; ++i)
    EXPECT_NEAR(out[i], 1.5 * y1[i] - 0.4 * y2[i] + 0.2 * y0[i] + 0.01 * rate[i] + 0.03 * f0[i],
                1e-13 * (1 + std::abs(0.01 * rate[i])));
}

TEST(JouleHeat, IsThePowerOfTheElectrodes) {
  // V I = sum of the branches' heat, also where heat flows into nodes of fixed temperature: none here.
  Thermoelectric settings{.nodes = 40};
  const auto rhs = settings.build();
  const Network network = settings.electric_network();
  const auto potential = steady_state(network);
  std::vector<double> y(rhs->size(), 0.0);
  std::copy(potential.begin(), potential.end(), y.begin());
  double current = 0;  // into the network at the electrode of 1 V
  for (const auto& edge : network.ghost_edges)
    if (network.ghost_value[static_cast<std::size_t>(edge.ghost)] == 1)
      current += edge.conductance * (1 - y[static_cast<std::size_t>(edge.row)]);
  const double heat = rhs->inflow(0, y);
  EXPECT_NEAR(heat, 1.0 * current, 1e-10 * heat);
}

TEST(ConjugateGradients, FindTheSteadyState) {
  const Network network = Thermoelectric{.nodes = 60}.electric_network();
  const auto exact = steady_state(network), found = approximate_steady_state(network, 1e-12);
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(found[i], exact[i], 1e-9);
}

/// A voltage that is there from the start and switched off by a step: heat until then, none later.
TEST(SteadyPotential, SwitchedOffByAStepIsABreakpoint) {
  const auto rhs = Thermoelectric{.steady = true, .electrode = {{1, 1}, {0.5, 0}}}.build();
  ASSERT_EQ(rhs->facts().breakpoints.size(), 1u);
  EXPECT_EQ(rhs->facts().breakpoints[0].t, 1);
  EXPECT_GT(rhs->facts().breakpoints[0].jump[0], 0);
  const std::vector<double> y(rhs->size(), 0.0);
  const auto heat = [&](double begin, double end, double t) {
    rhs->enter(begin, end);
    const double inflow = rhs->inflow(t, y);
    rhs->leave();
    return inflow;
  };
  EXPECT_GT(heat(0, 1, 1), heat(1, 2, 1) + 1e-3);
}

/// The middle of two pieces, one-sided limits at their ends, and what lies beyond.
TEST(Pieces, AreLinesForAnyTime) {
  const auto rhs = Thermoelectric{.nodes = 12, .convection = true, .tables = true}.build();
  ASSERT_FALSE(rhs->facts().breakpoints.empty());
  const double knot = rhs->facts().breakpoints.back().t;
  const std::vector<double> y(rhs->size(), 0.3);
  const auto rate = [&](double t) {
    std::vector<double> out(rhs->size());
    (*rhs)(t, y, out);
    return out;
  };
  const auto middle = rate(0.5 * knot), at_knot = rate(knot);
  rhs->enter(0, knot);
  EXPECT_EQ(rate(0.5 * knot), middle);
  const auto beyond = rate(1.5 * knot);
  rhs->enter(knot, 2 * knot);
  EXPECT_EQ(rate(1.2 * knot), at_knot);  // the tables stand still behind their last knot
  rhs->leave();
  EXPECT_EQ(rate(1.5 * knot), at_knot);
  EXPECT_NE(beyond, at_knot);  // the first piece goes on as the line that it is
}

}  // namespace
}  // namespace superstep
