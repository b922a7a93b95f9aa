#include "contact/conductance.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace superstep {
namespace {

constexpr double pi = std::numbers::pi;

TEST(SeriesConductance, TwoEqualParticlesHalveOne) {
  // K_i = 1.08 * 85 * pi * 1e-6 = 2.88398e-4 W/K
  EXPECT_NEAR(series_conductance(85, 85, 1e-6), 0.5 * 2.88398e-4, 1e-9);
}

TEST(SeriesConductance, UnequalParticlesAddTheirResistances) {
  // Conductivities 1/(1.08 pi) and 3/(1.08 pi), a = 1: resistances 1 and 1/3.
  EXPECT_DOUBLE_EQ(series_conductance(1 / (1.08 * pi), 3 / (1.08 * pi), 1.0), 0.75);
}

TEST(SeriesConductance, TheGrainBoundaryStandsInSeries) {
  // Values of the source's thermal example at a = 1 um:
  // K_c = 0.17 * 85 * pi * 1e-12/0.2e-6 = 2.26980e-4, 2/K_i = 6934.86, 1/K_c = 4405.67, K = 1/11340.5 W/K.
  EXPECT_NEAR(series_conductance(85, 85, 1e-6, {.thickness = 0.2e-6, .reduction = 0.17}), 8.81794e-5, 1e-10);
  // kappa_eq of 1 and 3 is 1.5: K_c = 0.5 * 1.5 * pi * 4/0.1.
  const double particles = 1 / series_conductance(1, 3, 2.0);
  const double with_boundary = 1 / series_conductance(1, 3, 2.0, {.thickness = 0.1, .reduction = 0.5});
  EXPECT_NEAR(with_boundary - particles, 0.1 / (0.5 * 1.5 * pi * 4), 1e-15);
}

TEST(SeriesConductance, AVanishingGrainBoundaryIsNone) {
  EXPECT_EQ(series_conductance(85, 40, 1e-6, {.thickness = 0, .reduction = 0.17}),
            series_conductance(85, 40, 1e-6));
  EXPECT_NEAR(series_conductance(85, 40, 1e-6, {.thickness = 1e-20, .reduction = 0.17}) /
                  series_conductance(85, 40, 1e-6),
              1.0, 1e-12);
}

TEST(PipeConductance, IsMeanConductivityTimesAreaOverDistance) {
  EXPECT_DOUBLE_EQ(pipe_conductance(1, 3, 0.5, 4.0), 2.0 * pi * 0.25 / 4.0);
}

}  // namespace
}  // namespace superstep
