/// Particles that touch nobody, and fields of which nothing is left to solve.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "case/scene.hpp"
#include "integrators/registry.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

class LoneParticles : public testing::Test {
 protected:
  Scene load(const std::string& tables) {
    folder_.write("p.csv", "id,x,y,z,radius\n0,0,0,0,0.001\n1,0,0,0.01,0.001\n");
    return load_scene(folder_.write("c.toml",
                                    "t_end = 5\n[packing]\nfile = \"p.csv\"\n[contact]\nneck = \"hertz\"\n"
                                    "[material]\ndensity = 5000\n[thermal]\nconductivity = 1.0\n"
                                    "specific_heat = 300\ninitial = 300\n" +
                                        tables));
  }
  static std::vector<double> end_values(const Scene& scene, const std::string& spec, std::size_t field,
                                        double settle_tolerance = 0) {
    Plan plan;
    plan.settle_tolerance = settle_tolerance;
    plan.output_times = {scene.t_end};
    for (const auto& one : scene.fields)
      if (!one.steady) plan.ranges.push_back(one.range_of_state());
    const auto integrator = make_integrator(spec);
    integrator->prepare(*scene.rhs, plan);
    integrator->start(0, scene.initial);
    const Outcome outcome = integrator->advance(scene.t_end);
    EXPECT_TRUE(outcome.ok()) << spec << ": " << outcome.reason;
    return scene.values_on_nodes(field, scene.t_end, integrator->state());
  }
  test::TemporaryFolder folder_;
  const double volume_ = 4.0 / 3 * std::numbers::pi * 1e-9;
};

/// V = I t/C, whatever steps the potential beside a temperature.
TEST_F(LoneParticles, GainThePotentialOfTheirSource) {
  const Scene scene = load(
      "[electric]\nmode = \"transient\"\nconductivity = 1e4\nspecific_capacity = 100\n"
      "source = [ { where = { ids = [0] }, value = { times = [0, 5], values = [0, 2e-5] } } ]\n");
  const double expected = 1e-5 * 5 / (5000 * volume_ * 100);
  for (const char* spec : {"exponential", "auto:rtol=1e-6", "esdirk:rtol=1e-6", "rkc:rtol=1e-6"})
    EXPECT_NEAR(end_values(scene, spec, 0)[0], expected, 1e-5 * expected) << spec;
}

/// It looks as if it stood still beside what it will be.
TEST_F(LoneParticles, AreNeverTakenForSettledWhileASourceFeedsThem) {
  const Scene scene = load(
      "[electric]\nmode = \"transient\"\nconductivity = 1e4\nspecific_capacity = 100\n"
      "source = [ { where = { ids = [0] }, value = 1e-5 } ]\n[coupling]\njoule_heat = false\n");
  const double expected = 1e-5 * 5 / (5000 * volume_ * 100);
  for (const char* spec : {"auto", "rkc:rtol=1e-4", "cvode:rtol=1e-4", "exponential:rtol=1e-4"})
    EXPECT_NEAR(end_values(scene, spec, 0, 1e-4)[0], expected, 1e-3 * expected) << spec;
}

TEST_F(LoneParticles, NeedNoSolveWhereAllThatAreJoinedAreHeld) {
  const Scene scene = load(
      "source = [ { where = { ids = [1] }, value = 0.001 } ]\n[electric]\nmode = \"steady\"\n"
      "conductivity = 1e4\nfixed = [ { where = { ids = [0] }, value = { times = [0, 0.5], values = [0, 0.01] "
      "} } ]\n");
  const double expected = 300 + 0.001 * 5 / (5000 * volume_ * 300);
  for (const char* spec : {"auto", "cvode:rtol=1e-6", "rkc:rtol=1e-6"})
    EXPECT_NEAR(end_values(scene, spec, 1)[1], expected, 1e-5 * (expected - 300)) << spec;
}

}  // namespace
}  // namespace superstep
