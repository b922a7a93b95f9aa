/// Sweeps with conductances of the state, against their reference; laws over vectors, against one by one.

#include "rhs/kernels/varying_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rhs/kernels/law_values.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

constexpr ConductanceMean means[] = {ConductanceMean::harmonic, ConductanceMean::arithmetic};

struct Fixture {
  Fixture(const Graph& graph, ConductanceMean mean_of_branches)
      : mean(mean_of_branches), network(build_network(graph, test::plain_roles(graph))) {
    for (std::size_t i = 0; i < network.size(); ++i)
      for (auto k = network.row_begin[i]; k < network.row_begin[i + 1]; ++k)
        geometry.push_back(network.conductance[static_cast<std::size_t>(k)] / network.capacity[i]);
    rows = SlicedRows(network.row_begin, network.column);
    rows.set_values(network.row_begin,
                    [&](std::size_t, std::size_t k) { return geometry_factor(mean) * geometry[k]; });
    for (std::size_t i = 0; i < network.size(); ++i) {
      const auto x = static_cast<double>(i);
      conductivity.push_back(3 + 2.9 * std::sin(0.7 * x));
      y.push_back(std::sin(0.1 + 1.7 * x));
      other.push_back(std::cos(x));
      nodes.push_back({y[i], node_factor(mean, conductivity[i])});
    }
  }
  [[nodiscard]] Stage stage() const {
    return {.y1 = y.data(),
            .a = 0.75,
            .d = 0.3,
            .y2 = other.data(),
            .b = -0.4,
            .y0 = other.data(),
            .c = 0.65,
            .f0 = other.data(),
            .e = 0.2};
  }
  [[nodiscard]] std::vector<double> swept_by(const VaryingKernel& kernel) const {
    std::vector<double> out(y.size(), 1e300);
    kernel.sweep(mean)(rows, nodes.data(), stage(), 0, rows.slices(), out.data());
    return out;
  }

  ConductanceMean mean;
  Network network;
  std::vector<double> geometry, conductivity, y, other;
  SlicedRows rows;
  std::vector<NodePair> nodes;
};

void expect_all_kernels_match(const Graph& graph) {
  for (const auto mean : means) {
    const Fixture fixture(graph, mean);
    std::vector<double> expected(fixture.y.size());
    reference_varying_sweep(mean, fixture.network.row_begin, fixture.network.column, fixture.geometry,
                            fixture.conductivity, fixture.stage(), expected.data());
    for (const auto& kernel : varying_kernels()) {
      const auto out = fixture.swept_by(kernel);
      for (std::size_t i = 0; i < out.size(); ++i) {
        double flows = 2;  // what is added up in this row: some five roundings a branch are relative to it
        for (auto k = fixture.network.row_begin[i]; k < fixture.network.row_begin[i + 1]; ++k)
          flows += 12 * fixture.geometry[static_cast<std::size_t>(k)];
        const auto length = fixture.network.row_begin[i + 1] - fixture.network.row_begin[i];
        EXPECT_NEAR(out[i], expected[i], 1.2e-16 * static_cast<double>(length + 10) * flows)
            << kernel.name << " row " << i;
      }
    }
  }
}

TEST(VaryingSweep, KernelsMatchTheReferenceForEverySizeOfTheLastSlice) {
  for (std::size_t nodes = 3; nodes < 28; ++nodes)
    expect_all_kernels_match(test::random_graph({.nodes = nodes, .seed = nodes}));
  expect_all_kernels_match(test::random_graph({.nodes = 1500, .seed = 9, .contrast = 1e4}));
  expect_all_kernels_match(test::star(50));
}

TEST(VaryingSweep, InstructionSetsWithFusedMultiplyAddAgreeBitByBit) {
  if (varying_kernels().size() < 3) GTEST_SKIP() << "this machine has no AVX-512";
  for (const auto mean : means) {
    const Fixture fixture(test::random_graph({.nodes = 803, .seed = 5, .contrast = 1e3}), mean);
    EXPECT_EQ(fixture.swept_by(varying_kernels()[0]), fixture.swept_by(varying_kernels()[1]));
  }
}

TEST(VaryingSweep, UniformStateStaysExactly) {
  for (const auto mean : means) {
    Fixture fixture(test::random_graph({.nodes = 205, .seed = 3, .contrast = 1e6}), mean);
    for (auto& node : fixture.nodes) node.value = 300.1;
    for (const auto& kernel : varying_kernels()) {
      std::vector<double> out(fixture.y.size());
      kernel.sweep(mean)(fixture.rows, fixture.nodes.data(), {.a = 1, .d = 0.37}, 0, fixture.rows.slices(),
                         out.data());
      EXPECT_EQ(out, std::vector<double>(out.size(), 300.1)) << kernel.name;
    }
  }
}

TEST(VaryingSweep, HeatMatchesItsDefinition) {
  for (const auto mean : means) {
    const Fixture fixture(test::random_graph({.nodes = 203, .seed = 12, .contrast = 30}), mean);
    const auto& network = fixture.network;
    std::vector<double> scale(network.size(), 0.25);
    for (const auto& kernel : varying_kernels()) {
      std::vector<double> out(network.size());
      kernel.heat(mean)(fixture.rows, fixture.nodes.data(), scale.data(), 0, fixture.rows.slices(),
                        out.data());
      for (std::size_t i = 0; i < network.size(); ++i) {
        double heat = 0;
        for (auto k = static_cast<std::size_t>(network.row_begin[i]);
             k < static_cast<std::size_t>(network.row_begin[i + 1]); ++k) {
          const auto j = static_cast<std::size_t>(network.column[k]);
          const double dv = fixture.y[j] - fixture.y[i];
          with_mean(mean, [&](auto mix) {
            heat +=
                fixture.geometry[k] * mix.heat(fixture.conductivity[i], fixture.conductivity[j]) * dv * dv;
          });
        }
        EXPECT_NEAR(out[i], 0.25 * heat, 1e-14 * heat) << kernel.name << " row " << i;  // terms are positive
      }
    }
  }
}

std::vector<ConductivityLaw> laws() {
  using Kind = ConductivityLaw::Kind;
  ConductivityLaw table{.kind = Kind::table, .value = 20};
  table.temperatures = {-50, 0, 3, 400};
  table.values = {20, 80, 5, 60};
  return {{.kind = Kind::constant, .value = 7},
          {.kind = Kind::linear, .value = 85, .coefficient = -5e-3, .reference = 300},
          {.kind = Kind::linear,
           .value = 85,
           .coefficient = 5e-3,
           .reference = 0,
           .outside = ConductivityLaw::Outside::clamp},
          table,
          {.kind = Kind::sigmoid, .value = 1e4, .reference = 380, .amplitude = 1.5, .steepness = 0.05},
          {.kind = Kind::sigmoid, .value = 1, .reference = 0, .amplitude = -0.9, .steepness = 20}};
}

TEST(LawValues, AreThoseOfTheLawOneByOne) {
  std::vector<double> temperature;
  for (int k = -400; k < 900; ++k) temperature.push_back(k + 0.37 * std::sin(k));
  for (const double extreme : {-1e9, -1e4, 0.0, 1e4, 1e9}) temperature.push_back(extreme);
  for (const auto& law : laws())
    for (const auto& kernel : law_kernels()) {
      std::vector<double> out(temperature.size());
      kernel.values(law, temperature.data(), temperature.size(), out.data());
      double largest = 0;
      for (const double t : temperature)
        largest = std::max(largest, std::abs(law.at(std::clamp(t, -400., 900.))));
      for (std::size_t i = 0; i < out.size(); ++i)
        // Roundings of the parts of a sum, and of the argument of an exponential some hundred in size.
        EXPECT_NEAR(out[i], law.at(temperature[i]), 1e-14 * std::max(largest, std::abs(out[i])))
            << kernel.name << ' ' << static_cast<int>(law.kind) << " at " << temperature[i];
    }
}

TEST(LawSlopes, AreThoseOfTheLawOneByOne) {
  std::vector<double> temperature{-50, 0, 3, 400};  // the points of the table: the piece that begins there
  for (int k = -400; k < 900; ++k) temperature.push_back(k + 0.37 * std::sin(k));
  for (const double extreme : {-1e9, -1e4, 1e4, 1e9}) temperature.push_back(extreme);
  for (const auto& law : laws())
    for (const auto& kernel : law_kernels()) {
      std::vector<double> out(temperature.size());
      kernel.slopes(law, temperature.data(), temperature.size(), out.data());
      double largest = 0;
      for (const double t : temperature) largest = std::max(largest, std::abs(law.slope(t)));
      for (std::size_t i = 0; i < out.size(); ++i)
        EXPECT_NEAR(out[i], law.slope(temperature[i]), 1e-13 * largest)
            << kernel.name << ' ' << static_cast<int>(law.kind) << " at " << temperature[i];
    }
}

/// A table that falls over twenty decades: what it says where it is small has all its digits.
TEST(LawValues, OfATableLoseNothingToLargeValuesElsewhere) {
  ConductivityLaw table{.kind = ConductivityLaw::Kind::table, .value = 1};
  table.temperatures = {0, 100, 200};
  table.values = {1e20, 1, 2};
  std::vector<double> temperature;
  for (double t = 100; t < 300; t += 3.7) temperature.push_back(t);
  for (const auto& kernel : law_kernels()) {
    std::vector<double> out(temperature.size());
    kernel.values(table, temperature.data(), temperature.size(), out.data());
    for (std::size_t i = 0; i < out.size(); ++i)
      EXPECT_NEAR(out[i], table.at(temperature[i]), 1e-14) << kernel.name << ' ' << temperature[i];
  }
}

TEST(LawValues, DoNotDependOnWhereARangeEnds) {
  std::vector<double> temperature;
  for (int k = 0; k < 61; ++k) temperature.push_back(300 + 7 * std::sin(k));
  for (const auto& law : laws()) {
    std::vector<double> whole(temperature.size()), parts(temperature.size());
    law_values(law, temperature, whole);
    for (std::size_t from = 0; from < temperature.size(); from += 13) {
      const std::size_t count = std::min<std::size_t>(13, temperature.size() - from);
      law_values(law, std::span(temperature).subspan(from, count), std::span(parts).subspan(from, count));
    }
    EXPECT_EQ(whole, parts);
    if (law_kernels().size() < 3) continue;
    law_kernels()[0].values(law, temperature.data(), temperature.size(), whole.data());
    law_kernels()[1].values(law, temperature.data(), temperature.size(), parts.data());
    EXPECT_EQ(whole, parts);
    law_kernels()[0].slopes(law, temperature.data(), temperature.size(), whole.data());
    law_kernels()[1].slopes(law, temperature.data(), temperature.size(), parts.data());
    EXPECT_EQ(whole, parts);
  }
}

}  // namespace
}  // namespace superstep
