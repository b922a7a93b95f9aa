#include "rhs/kernels/sweep.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

#include "rhs/kernels/field_operator.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

using test::random_graph;

struct Fixture {
  explicit Fixture(const Graph& graph) : network(build_network(graph, test::plain_roles(graph))) {
    for (std::size_t i = 0; i < network.size(); ++i)
      for (auto k = network.row_begin[i]; k < network.row_begin[i + 1]; ++k)
        rate.push_back(network.conductance[static_cast<std::size_t>(k)] / network.capacity[i]);
    sliced = SlicedRows(network.row_begin, network.column);
    sliced.set_values(network.row_begin, [&](std::size_t, std::size_t k) { return rate[k]; });
  }
  [[nodiscard]] SweepRows rows() const { return {network.row_begin, network.column, rate}; }
  [[nodiscard]] std::size_t size() const { return network.size(); }

  Network network;
  std::vector<double> rate;
  SlicedRows sliced;
};

std::vector<double> wave(std::size_t n, double phase) {
  std::vector<double> y(n);
  for (std::size_t k = 0; k < n; ++k) y[k] = std::sin(phase + 1.7 * static_cast<double>(k));
  return y;
}

/// Every subset of the optional terms: bit 0 y2, bit 1 y0, bit 2 f0.
Stage stage_with(int terms, const std::vector<double>& y1, const std::vector<double>& y2,
                 const std::vector<double>& y0, const std::vector<double>& f0) {
  return {.y1 = y1.data(),
          .a = 0.75,
          .d = 0.3,
          .y2 = terms & 1 ? y2.data() : nullptr,
          .b = -0.4,
          .y0 = terms & 2 ? y0.data() : nullptr,
          .c = 0.65,
          .f0 = terms & 4 ? f0.data() : nullptr,
          .e = 0.2};
}

void expect_all_kernels_match(const Graph& graph) {
  const Fixture fixture(graph);
  const std::size_t n = fixture.size();
  const auto y1 = wave(n, 0.1), y2 = wave(n, 1.1), y0 = wave(n, 2.1), f0 = wave(n, 3.1);
  for (int terms = 0; terms < 8; ++terms) {
    const Stage stage = stage_with(terms, y1, y2, y0, f0);
    std::vector<double> expected(n);
    reference_sweep(fixture.rows(), stage, expected.data());
    for (const auto& kernel : sweep_kernels()) {
      std::vector<double> out(n, 1e300);
      kernel.sweep(fixture.sliced, stage, 0, fixture.sliced.slices(), out.data());
      for (std::size_t i = 0; i < n; ++i) {
        double flows = 2;  // sum of what is added up in this row: roundings are relative to it
        for (auto k = fixture.network.row_begin[i]; k < fixture.network.row_begin[i + 1]; ++k)
          flows += 2 * fixture.rate[static_cast<std::size_t>(k)];
        const auto length = fixture.network.row_begin[i + 1] - fixture.network.row_begin[i];
        EXPECT_NEAR(out[i], expected[i], 1.2e-16 * static_cast<double>(length + 6) * flows)
            << kernel.name << " n " << n << " row " << i << " terms " << terms;
      }
    }
  }
}

TEST(Sweep, KernelsMatchTheReferenceForEverySizeOfTheLastSlice) {
  for (std::size_t nodes = 3; nodes < 28; ++nodes)
    expect_all_kernels_match(random_graph({.nodes = nodes, .seed = nodes}));
  expect_all_kernels_match(random_graph({.nodes = 1500, .seed = 9, .contrast = 1e4}));
}

TEST(Sweep, KernelsMatchTheReferenceOnLopsidedRows) {
  expect_all_kernels_match(test::star(50));
  expect_all_kernels_match(test::chain(17));
}

TEST(Sweep, NoSliceAtAll) {
  const std::vector<std::int64_t> row_begin{0};
  const SlicedRows none(row_begin, {});
  EXPECT_EQ(none.slices(), 0U);
  double untouched = 7;
  fused_sweep(none, {.y1 = &untouched}, &untouched);
  EXPECT_EQ(untouched, 7);
}

TEST(Sweep, InstructionSetsWithFusedMultiplyAddAgreeBitByBit) {
  std::vector<SweepKernel> fused;
  for (const auto& kernel : sweep_kernels())
    if (std::string(kernel.name) != "baseline") fused.push_back(kernel);
  if (fused.size() < 2) GTEST_SKIP() << "this machine has no AVX-512";
  const Fixture fixture(random_graph({.nodes = 803, .seed = 5, .contrast = 1e3}));
  const std::size_t n = fixture.size();
  const auto y1 = wave(n, 0.1), y2 = wave(n, 1.1), y0 = wave(n, 2.1), f0 = wave(n, 3.1);
  const Stage stage = stage_with(7, y1, y2, y0, f0);
  std::vector<double> a(n), b(n);
  fused[0].sweep(fixture.sliced, stage, 0, fixture.sliced.slices(), a.data());
  fused[1].sweep(fixture.sliced, stage, 0, fixture.sliced.slices(), b.data());
  EXPECT_EQ(a, b);
}

TEST(Sweep, UniformStateStaysExactly) {
  const Fixture fixture(random_graph({.nodes = 205, .seed = 3, .contrast = 1e6}));
  const std::vector<double> y(fixture.size(), 300.1);
  for (const auto& kernel : sweep_kernels()) {
    std::vector<double> out(y.size());
    kernel.sweep(fixture.sliced, {.y1 = y.data(), .a = 1, .d = 0.37}, 0, fixture.sliced.slices(), out.data());
    EXPECT_EQ(out, y) << kernel.name;
  }
}

TEST(Sweep, OutMayBeTheOlderStage) {
  const Fixture fixture(random_graph({.nodes = 101, .seed = 8}));
  const auto y1 = wave(fixture.size(), 0.1), y2 = wave(fixture.size(), 1.1);
  const Stage apart = stage_with(1, y1, y2, y2, y2);
  std::vector<double> expected(y1.size()), in_place = y2;
  fused_sweep(fixture.sliced, apart, expected.data());
  Stage aliased = apart;
  aliased.y2 = in_place.data();
  fused_sweep(fixture.sliced, aliased, in_place.data());
  EXPECT_EQ(in_place, expected);
}

TEST(Sweep, PaddingDoesNotSpreadWhatIsNotFinite) {
  const Fixture fixture(test::star(20));
  auto y = wave(fixture.size(), 0.4);
  const std::size_t bad = fixture.size() - 1;  // a leaf; only it and the hub may know
  y[bad] = std::nan("");
  std::vector<double> out(y.size());
  fused_sweep(fixture.sliced, {.y1 = y.data(), .a = 1, .d = 0.1}, out.data());
  std::size_t spoilt = 0;
  for (const double value : out) spoilt += std::isnan(value) ? 1 : 0;
  EXPECT_EQ(spoilt, 2U);
}

TEST(Sweep, ThreadsDoNotChangeTheResult) {
  const Fixture fixture(random_graph({.nodes = 9001, .seed = 6}));  // large enough for a team
  const std::size_t n = fixture.size();
  ASSERT_GT(n, smallest_parallel_range);
  const auto y1 = wave(n, 0.1), y2 = wave(n, 1.1), y0 = wave(n, 2.1), f0 = wave(n, 3.1);
  const Stage stage = stage_with(7, y1, y2, y0, f0);
  const int before = omp_get_max_threads();
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 2, 5}) {
    omp_set_num_threads(threads);
    results.emplace_back(n);
    fused_sweep(fixture.sliced, stage, results.back().data());
  }
  omp_set_num_threads(before);
  EXPECT_EQ(results[1], results[0]);
  EXPECT_EQ(results[2], results[0]);
}

TEST(Sweep, HeatMatchesItsDefinition) {
  for (const std::size_t nodes : {6U, 13U, 400U}) {
    const Fixture fixture(random_graph({.nodes = nodes, .seed = nodes}));
    const std::size_t n = fixture.size();
    const auto v = wave(n, 0.7);
    std::vector<double> scale(n), expected(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      scale[i] = 1 / fixture.network.capacity[i];
      for (auto k = fixture.network.row_begin[i]; k < fixture.network.row_begin[i + 1]; ++k) {
        const double dv =
            v[static_cast<std::size_t>(fixture.network.column[static_cast<std::size_t>(k)])] - v[i];
        expected[i] += scale[i] * fixture.rate[static_cast<std::size_t>(k)] * dv * dv;
      }
    }
    for (const auto& kernel : sweep_kernels()) {
      std::vector<double> out(n);
      kernel.heat(fixture.sliced, v.data(), scale.data(), 0, fixture.sliced.slices(), out.data());
      for (std::size_t i = 0; i < n; ++i)
        EXPECT_NEAR(out[i], expected[i], 1e-14 * expected[i]) << kernel.name;  // terms of one sign
    }
  }
}

TEST(Sweep, NewConductancesReachTheLayoutInPlace) {
  const Graph graph = random_graph({.nodes = 61, .seed = 12});
  const Fixture fixture(graph);
  FieldOperator field(fixture.network);
  std::vector<double> doubled = fixture.network.conductance, ghosts;
  for (double& conductance : doubled) conductance *= 2;
  for (const auto& edge : fixture.network.ghost_edges) ghosts.push_back(edge.conductance);
  const auto y = wave(fixture.size(), 0.3);
  std::vector<double> before(y.size()), after(y.size());
  const std::vector<double> zero(y.size(), 0.0);
  field.set_conductances(doubled, ghosts);
  field.conduction_stage({.y1 = y.data(), .a = 0, .d = 1}, after.data());
  for (auto& edge : ghosts) edge /= 2;
  field.set_conductances(fixture.network.conductance, ghosts);
  field.conduction_stage({.y1 = y.data(), .a = 0, .d = 2}, before.data());
  EXPECT_EQ(after, before);  // powers of two: no rounding differs
}

TEST(Ordering, SlicesNeedLittlePadding) {
  const Fixture fixture(random_graph({.nodes = 5000, .seed = 2}));
  EXPECT_LT(static_cast<double>(fixture.sliced.entries()),
            1.2 * static_cast<double>(fixture.network.nonzeros()));
}

}  // namespace
}  // namespace superstep
