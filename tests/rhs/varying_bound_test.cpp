/// Row sums of Jacobians whose conductances follow a state, against sums of the derivatives one by one.

#include "rhs/kernels/varying_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/problem.hpp"

namespace superstep {
namespace {

constexpr ConductanceMean means[] = {ConductanceMean::harmonic, ConductanceMean::arithmetic};

/// A network at some state: every fifth temperature is known, every third potential.
struct State {
  State(const Graph& graph, ConductanceMean mean_of_branches)
      : mean(mean_of_branches), network(build_network(graph, test::plain_roles(graph))) {
    rows = SlicedRows(network.row_begin, network.column);
    rows.set_values(network.row_begin, [&](std::size_t, std::size_t k) {
      return geometry_factor(mean) * network.conductance[k];
    });
    for (std::size_t i = 0; i < network.size(); ++i) {
      const auto x = static_cast<double>(i);
      conductivity.push_back(3 + 2.9 * std::sin(0.7 * x));
      slope.push_back(std::cos(1.3 * x));
      value.push_back(300 + std::sin(0.1 + 1.7 * x));
      inverse_capacity.push_back(1 + 0.5 * std::sin(x));
      warms.push_back(i % 5 == 0 ? 0 : 1);
      moves.push_back(i % 3 == 0 ? 0 : 1);
      nodes.push_back({value[i], node_factor(mean, conductivity[i])});
      bend.push_back(warms[i] * node_bend(mean, conductivity[i], slope[i]));
    }
  }
  /// Calls each(other, conductance at conductivity 1, difference of the values) for the branches of a row.
  template <class Each>
  void for_branches(std::size_t row, const Each& each) const {
    for (auto k = network.row_begin[row]; k < network.row_begin[row + 1]; ++k) {
      const auto other = static_cast<std::size_t>(network.column[static_cast<std::size_t>(k)]);
      each(other, network.conductance[static_cast<std::size_t>(k)], value[other] - value[row]);
    }
  }
  struct Sums {
    std::vector<double> first, second;
    bool operator==(const Sums&) const = default;
  };
  [[nodiscard]] Sums by(const BoundKernel& kernel) const {
    Sums out{std::vector<double>(network.size(), -1), std::vector<double>(network.size(), -1)};
    const auto sums = mean == ConductanceMean::harmonic ? kernel.harmonic : kernel.arithmetic;
    sums(rows, nodes.data(), bend.data(), 0, rows.slices(), {out.first, out.second});
    return out;
  }
  [[nodiscard]] Sums heat_by(const BoundKernel& kernel) const {
    Sums out{std::vector<double>(network.size(), 7), std::vector<double>(network.size(), 11)};
    const auto heat = mean == ConductanceMean::harmonic ? kernel.harmonic_heat : kernel.arithmetic_heat;
    heat(rows, {nodes.data(), bend.data(), moves.data()}, inverse_capacity.data(), 0, rows.slices(),
         {out.first, out.second});
    return out;
  }

  ConductanceMean mean;
  Network network;
  SlicedRows rows;
  std::vector<double> conductivity, slope, value, inverse_capacity, warms, moves, bend;
  std::vector<NodePair> nodes;
};

template <class Check>
void for_states(const Check& check) {
  for (const auto mean : means) {
    for (std::size_t nodes = 3; nodes < 28; ++nodes)
      check(State(test::random_graph({.nodes = nodes, .seed = nodes, .contrast = 30}), mean));
    check(State(test::star(50), mean));
  }
}

TEST(VaryingBound, ConductionAndLawsAreSumsOfTheirDerivatives) {
  for_states([](const State& state) {
    for (const auto& kernel : bound_kernels()) {
      const auto out = state.by(kernel);
      for (std::size_t i = 0; i < state.network.size(); ++i) {
        double conduction = 0, laws = 0;
        with_mean(state.mean, [&](auto mean) {
          state.for_branches(i, [&](std::size_t j, double geometry, double difference) {
            const double a = state.conductivity[i], b = state.conductivity[j];
            conduction += geometry * mean.value(a, b);
            laws += std::abs(geometry * difference * mean.slope(a, b) * state.slope[i]) * state.warms[i];
            laws += std::abs(geometry * difference * mean.slope(b, a) * state.slope[j]) * state.warms[j];
          });
        });
        EXPECT_NEAR(out.first[i], conduction, 1e-13 * conduction) << kernel.name << " row " << i;
        EXPECT_NEAR(out.second[i], laws, 1e-13 * laws) << kernel.name << " row " << i;
      }
    }
  });
}

TEST(VaryingBound, HeatAddsTheSumsOfItsDerivatives) {
  for_states([](const State& state) {
    for (const auto& kernel : bound_kernels()) {
      const auto out = state.heat_by(kernel);
      for (std::size_t i = 0; i < state.network.size(); ++i) {
        double temperatures = 0, potentials = 0;
        with_mean(state.mean, [&](auto mean) {
          state.for_branches(i, [&](std::size_t j, double geometry, double difference) {
            const double a = state.conductivity[i], b = state.conductivity[j];
            const double heat = geometry * difference * difference;
            temperatures += std::abs(heat * mean.heat_slope_a(a, b) * state.slope[i]) * state.warms[i];
            temperatures += std::abs(heat * mean.heat_slope_b(a, b) * state.slope[j]) * state.warms[j];
            potentials +=
                std::abs(2 * geometry * mean.heat(a, b) * difference) * (state.moves[i] + state.moves[j]);
          });
        });
        temperatures = 7 + temperatures * state.inverse_capacity[i];
        potentials = 11 + potentials * state.inverse_capacity[i];
        EXPECT_NEAR(out.first[i], temperatures, 1e-13 * temperatures) << kernel.name << " row " << i;
        EXPECT_NEAR(out.second[i], potentials, 1e-13 * potentials) << kernel.name << " row " << i;
      }
    }
  });
}

/// Steps follow from these sums: they must not depend on which of the two a machine has.
TEST(VaryingBound, InstructionSetsWithFusedMultiplyAddAgreeBitByBit) {
  if (bound_kernels().size() < 3) GTEST_SKIP() << "this machine has no AVX-512";
  for (const auto mean : means) {
    const State state(test::random_graph({.nodes = 803, .seed = 5, .contrast = 1e3}), mean);
    EXPECT_EQ(state.by(bound_kernels()[0]), state.by(bound_kernels()[1]));
    EXPECT_EQ(state.heat_by(bound_kernels()[0]), state.heat_by(bound_kernels()[1]));
  }
}

}  // namespace
}  // namespace superstep
