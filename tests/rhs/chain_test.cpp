/// Stages that pass over the network together must give what they give one by one, bit by bit.

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>

#include "rhs/network_rhs.hpp"
#include "support/band.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

using test::band;
using test::small_cache;
using test::Threads;

/// Checks that entries come stage by stage, and keeps what they were.
class Copies final : public ChainObserver {
 public:
  Copies(std::span<const ChainedStage> chain, std::size_t size)
      : chain_(chain), seen_(size, 0), copy(chain.size(), std::vector<double>(size)) {}
  void entries_done(std::size_t stage, std::size_t first, std::size_t last) override {
    for (std::size_t i = first; i < last; ++i) {
      in_order = in_order && seen_[i] == stage;
      seen_[i] = stage + 1;
      copy[stage][i] = chain_[stage].out[i];
    }
  }

 private:
  std::span<const ChainedStage> chain_;
  std::vector<std::size_t> seen_;

 public:
  std::vector<std::vector<double>> copy;
  std::atomic<bool> in_order{true};
};

void expect_chain_is_its_stages(const Graph& graph, bool driven) {
  test::Problem problem(graph);
  auto& rhs = *problem.rhs;
  const std::size_t n = rhs.size();
  std::vector<double> drive;
  if (driven)
    for (std::size_t i = 0; i < n; ++i) drive.push_back(std::cos(static_cast<double>(i)));
  rhs.drive(drive);
  const double h = 0.3 / rhs.spectral_bound(0, problem.initial);

  // One by one, without a chain: a recurrence with every optional term.
  constexpr std::size_t stages = 11;
  std::vector<double> f0(n);
  rhs(0, problem.initial, f0);
  const auto stage = [&](std::size_t k, const double* y1, const double* y2) {
    return test::stage_of(k, h, y1, y2, problem.initial.data(), f0.data());
  };
  std::vector<std::vector<double>> expected;
  std::vector<double> expected_inflow;
  for (std::size_t k = 0; k < stages; ++k) {
    const double t = 0.1 * static_cast<double>(k);
    const auto& y1 = k == 0 ? problem.initial : expected[k - 1];
    const auto& y2 = k < 2 ? problem.initial : expected[k - 2];
    std::vector<double> out(n);
    rhs.stage(t, stage(k, y1.data(), y2.data()), out);
    expected_inflow.push_back(rhs.inflow(t, y1));
    expected.push_back(std::move(out));
  }

  for (const std::size_t cache : {small_cache, std::size_t{1} << 40})
    for (const int threads : {1, 2, 3}) {
      SCOPED_TRACE(testing::Message() << "cache " << cache << " threads " << threads);
      const Threads as_many(threads);
      rhs.assume_cache(cache);
      std::array<std::vector<double>, 2> buffer{std::vector<double>(n), std::vector<double>(n)};
      std::vector<ChainedStage> chain;
      for (std::size_t k = 0; k < stages; ++k) {
        const double* y1 = k == 0 ? problem.initial.data() : buffer[(k + 1) % 2].data();
        const double* y2 = k < 2 ? problem.initial.data() : buffer[k % 2].data();
        chain.push_back({0.1 * static_cast<double>(k), stage(k, y1, y2), buffer[k % 2].data()});
      }
      Copies copies(chain, n);
      const auto sweeps = rhs.counters().sweeps;
      rhs.chain(chain, true, &copies);
      EXPECT_EQ(rhs.counters().sweeps, sweeps + stages);
      EXPECT_TRUE(copies.in_order);
      for (std::size_t k = 0; k < stages; ++k) {
        EXPECT_EQ(copies.copy[k], expected[k]) << "stage " << k;
        EXPECT_EQ(chain[k].inflow, expected_inflow[k]) << "stage " << k;
      }
    }
}

TEST(Chain, IsItsStagesOneByOne) {
  expect_chain_is_its_stages(band(false, false), false);
}
TEST(Chain, WithRadiation) {
  expect_chain_is_its_stages(band(true, false), false);
}
TEST(Chain, WithInputsThatChange) {
  expect_chain_is_its_stages(band(true, true), false);
}
TEST(Chain, WithADrive) {
  expect_chain_is_its_stages(band(false, false), true);
}

TEST(Chain, IsDeepWhereTheNetworkLeavesTheCacheAndOnlyThere) {
  const Graph graph = band(false, false);
  FieldOperator field(build_network(graph, test::plain_roles(graph)));
  field.assume_cache(small_cache);
  {
    const Threads two(2);  // take a larger skew
    EXPECT_GE(field.chain_depth(), 2U);
  }
  const Threads one(1);
  EXPECT_GE(field.chain_depth(), 5U);
  field.assume_cache(std::size_t{1} << 40);
  EXPECT_EQ(field.chain_depth(), 1U);
  field.assume_cache(1000);  // not even two passes fit
  EXPECT_EQ(field.chain_depth(), 1U);
  const Graph changing = band(false, true);
  FieldOperator stepped(build_network(changing, test::plain_roles(changing)));
  stepped.assume_cache(small_cache);
  EXPECT_EQ(stepped.chain_depth(), 1U);
}

}  // namespace
}  // namespace superstep
