/// Stages of several processes that share one halo must give what one process gives stage by stage, bit by
/// bit.

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>

#include "network/part.hpp"
#include "rhs/kernels/field_operator.hpp"
#include "support/band.hpp"
#include "support/problem.hpp"
#include "support/thread_world.hpp"

namespace superstep {
namespace {

using test::band;
using test::small_cache;
using test::stage_of;

constexpr std::size_t stages = 11;

/// The whole of it in one process, one stage after the other.
struct Alone {
  explicit Alone(const Graph& graph, bool driven) : network(build_network(graph, test::plain_roles(graph))) {
    FieldOperator field(network);
    const std::size_t n = field.size();
    h = 0.3 / spectral_bounds(network).smallest();
    for (std::size_t i = 0; i < n; ++i) {
      start.push_back(std::sin(static_cast<double>(i)));
      if (driven) drive.push_back(std::cos(static_cast<double>(i)));
    }
    f0.resize(n);
    field.stage(0, {.y1 = start.data(), .a = 0, .d = 1}, f0.data());
    for (std::size_t k = 0; k < stages; ++k) {
      const auto& y1 = k == 0 ? start : result[k - 1];
      const auto& y2 = k < 2 ? start : result[k - 2];
      std::vector<double> out(n);
      field.stage(0, stage_of(k, h, y1.data(), y2.data(), start.data(), f0.data()), out.data());
      for (std::size_t i = 0; i < drive.size(); ++i) out[i] += h * drive[i];
      result.push_back(std::move(out));
    }
  }
  Network network;
  std::vector<double> start, drive, f0;
  std::vector<std::vector<double>> result;
  double h = 0;
};

/// Notes which own entries differ from those of one process.
class Comparison final : public ChainObserver {
 public:
  Comparison(const Alone& alone, std::size_t begin, std::span<const ChainedStage> chain, std::size_t size)
      : alone_(alone), begin_(begin), chain_(chain), seen(size, 0) {}
  void entries_done(std::size_t stage, std::size_t first, std::size_t last) override {
    for (std::size_t i = first; i < last; ++i) {
      if (seen[i] != stage || chain_[stage].out[i] != alone_.result[stage][begin_ + i]) ++wrong;
      seen[i] = stage + 1;
    }
  }

 private:
  const Alone& alone_;
  std::size_t begin_;
  std::span<const ChainedStage> chain_;

 public:
  std::vector<std::size_t> seen;
  std::atomic<std::size_t> wrong{0};
};

/// Twice, since what one chain fetched must not be taken for what another needs.
std::uint64_t wrong_entries(const Alone& alone, FieldOperator& field, const Partition& partition) {
  const auto begin = static_cast<std::size_t>(partition.begin());
  const auto part = [&](const std::vector<double>& whole) {
    return whole.empty()
               ? whole
               : std::vector<double>(whole.begin() + partition.begin(), whole.begin() + partition.end());
  };
  std::uint64_t wrong = 0;
  for (int time = 0; time < 2; ++time) {
    const std::vector<double> f0 = part(alone.f0), drive = part(alone.drive);
    std::vector<double> start = part(alone.start);
    const std::vector<double> first = start;
    std::array<std::vector<double>, 2> buffer{std::vector<double>(field.size()),
                                              std::vector<double>(field.size())};
    std::vector<ChainedStage> chain;
    for (std::size_t k = 0; k < stages; ++k) {
      const double* y1 = k == 0 ? start.data() : buffer[(k + 1) % 2].data();
      const double* y2 = k < 2 ? start.data() : buffer[k % 2].data();
      chain.push_back({0, stage_of(k, alone.h, y1, y2, first.data(), f0.data()), buffer[k % 2].data()});
    }
    Comparison comparison(alone, begin, chain, field.size());
    field.chain(chain, false, drive, &comparison);
    wrong += comparison.wrong;
    for (const std::size_t seen : comparison.seen) wrong += seen == stages ? 0 : 1;
  }
  return wrong;
}

void expect_same_bits(const Graph& graph, bool driven) {
  const Alone alone(graph, driven);
  for (const int processes : {2, 3, 4})
    for (const int threads : {1, 2})
      for (const std::size_t cache : {small_cache / 2, std::size_t{1} << 40}) {
        test::as_processes(processes, threads, [&](Communicator& among) {
          SCOPED_TRACE(testing::Message() << processes << " processes, " << threads << " threads, cache "
                                          << cache << " rank " << among.rank());
          const Partition partition(static_cast<std::int64_t>(alone.network.size()), processes, among.rank(),
                                    64);
          NetworkPart part = part_of(alone.network, partition);
          part.network.halo = std::make_shared<Halo>(among, partition, part.halo);
          FieldOperator field(std::move(part.network), threads == 1);
          field.assume_cache(cache);
          EXPECT_EQ(wrong_entries(alone, field, partition), 0U);
          if (threads == 1 || cache > small_cache) {                 // else too few rows stay in the cache
            EXPECT_EQ(field.stages_of_a_halo() > 1, processes < 4);  // more have too few rows each
          }
        });
      }
}

TEST(SharedChain, IsItsStagesOneByOne) {
  expect_same_bits(band(false, false), false);
}
TEST(SharedChain, WithRadiation) {
  expect_same_bits(band(true, false), false);
}
TEST(SharedChain, WithADrive) {
  expect_same_bits(band(false, false), true);
}

/// New conductances are those of rows beyond the cuts, too.
TEST(SharedChain, FollowsNewConductances) {
  Graph graph = band(false, false);
  const Network before = build_network(graph, test::plain_roles(graph));
  for (auto& conductance : graph.conductance) conductance *= 1.25;
  const Alone alone(graph, false);
  test::as_processes(2, 1, [&](Communicator& among) {
    const Partition partition(static_cast<std::int64_t>(before.size()), 2, among.rank(), 64);
    NetworkPart old = part_of(before, partition), now = part_of(alone.network, partition);
    old.network.halo = std::make_shared<Halo>(among, partition, old.halo);
    FieldOperator field(std::move(old.network));
    std::vector<double> y(field.size(), 300.0), z(field.size());
    std::array<ChainedStage, 2> chain{ChainedStage{0, {.y1 = y.data(), .a = 1, .d = alone.h}, z.data()},
                                      ChainedStage{0, {.y1 = z.data(), .a = 1, .d = alone.h}, y.data()}};
    field.chain(chain, false, {}, nullptr);
    std::vector<double> ghost;
    for (const auto& edge : now.network.ghost_edges) ghost.push_back(edge.conductance);
    field.set_conductances(now.network.conductance, ghost);
    EXPECT_EQ(wrong_entries(alone, field, partition), 0U);
  });
}

}  // namespace
}  // namespace superstep
