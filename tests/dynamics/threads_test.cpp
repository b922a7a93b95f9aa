/// Forces and heat of moving particles are the same bits for any number of threads. Clouds are large enough
/// for loops to be shared out; small ones are swept by one thread, whatever is asked for.

#include <gtest/gtest.h>
#include <omp.h>

#include <cstring>

#include "core/parallel.hpp"
#include "dynamics/moving_network.hpp"
#include "press.hpp"

namespace superstep {
namespace {

using namespace test;

struct Swept {
  std::vector<Vec3> force;
  std::vector<double> rate;
  std::vector<Bond> bonds;
  std::size_t pairs = 0;
};

/// Two instants of a step: bonds form at the first and act, and grow, at the second.
Swept sweep(const Model& model, const Cloud& cloud, int threads) {
  omp_set_num_threads(threads);
  State state = cloud.state;
  const Phase& phase = model.schedule.at(0);
  MovingNetwork network(model, cloud.particles);
  network.resume(state, phase);
  network.settle(state, phase);
  std::vector<Vec3> moved = state.position;
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = moved[i] + 1e-4 * state.velocity[i];
  network.place(moved, state.temperature, phase, 1e-4, {1e-4, 0.5});
  Swept out{std::vector<Vec3>(cloud.particles.size()), std::vector<double>(cloud.particles.size()),
            state.bonds, 0};
  (void)network.forces(state.velocity, state.temperature, out.force);
  network.rates(state.temperature, out.rate);
  out.pairs = network.placement().contacts.size();
  return out;
}

class AnyThreads : public testing::TestWithParam<BondRule> {};

TEST_P(AnyThreads, GiveTheSameBits) {
  Model model = quiet_model(3.0);
  model.contact = {1e7, 2, {500, 1e6}, 0.1, 0.05, 0.3};
  model.thermal.conductivity = 50;
  model.bond = {.stiffness = 5e5, .exponent = 2, .threshold = 0.1, .rule = GetParam(), .rupture = 0.4};
  model.bond.growth.rate = 1e3;
  model.bond.growth.activation = 1e5;
  const Cloud cloud = random_cloud(12'000, 1.4, 11);
  const int before = omp_get_max_threads();
  const Swept one = sweep(model, cloud, 1);
  ASSERT_GT(one.pairs / 4, smallest_parallel_range) << "else threads do not come in";
  ASSERT_GT(one.bonds.size() / 2, smallest_parallel_range) << "neither in bonds";
  for (const int threads : {2, 3, 5}) {
    const Swept many = sweep(model, cloud, threads);
    ASSERT_EQ(many.bonds.size(), one.bonds.size());
    EXPECT_EQ(std::memcmp(many.force.data(), one.force.data(), one.force.size() * sizeof(Vec3)), 0)
        << threads;
    EXPECT_EQ(std::memcmp(many.rate.data(), one.rate.data(), one.rate.size() * sizeof(double)), 0) << threads;
    EXPECT_EQ(std::memcmp(many.bonds.data(), one.bonds.data(), one.bonds.size() * sizeof(Bond)), 0)
        << threads;
  }
  omp_set_num_threads(before);
}

INSTANTIATE_TEST_SUITE_P(BondRules, AnyThreads,
                         testing::Values(BondRule::overlap, BondRule::tension, BondRule::rest_length));

}  // namespace
}  // namespace superstep
