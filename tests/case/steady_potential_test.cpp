/// A steady potential: how it is found, what it needs, and which method is not for it.

#include <gtest/gtest.h>

#include "support/case_texts.hpp"

namespace superstep {
namespace {

class SteadyPotentials : public test::CaseTexts {
 protected:
  static std::string pair_of(const std::string& mode, const std::string& thermal) {
    return "t_end = 1.0\n[packing]\nfile = \"pair.csv\"\n[contact]\nneck = \"hertz\"\n[material]\ndensity = "
           "5000\n"
           "[electric]\nconductivity = 1e5\nfixed = [ { where = { ids = [1] }, value = 0.1 }, "
           "{ where = { ids = [2] }, value = 0.0 } ]\nmode = " +
           mode + "\n[thermal]\nconductivity = 80\nspecific_heat = 500\ninitial = 300\n" + thermal;
  }
  /// Four spheres in a row.
  Scene row(const std::string& conductivity) {
    folder_.write("row.csv",
                  "id,x,y,z,r\n1,0,0,0,1e-3\n2,0,0,1.9e-3,1e-3\n3,0,0,3.8e-3,1e-3\n4,0,0,5.7e-3,1e-3\n");
    return load(
        "t_end = 1.0\n[packing]\nfile = \"row.csv\"\n[contact]\nneck = \"hertz\"\n[material]\ndensity = "
        "5000\n"
        "[electric]\nmode = \"steady\"\nconductivity = " +
        conductivity +
        "\nfixed = [ { where = { ids = [1] }, value = { times = [0, 1], values = [0, 0.1] } }, "
        "{ where = { ids = [4] }, value = 0.0 } ]\n"
        "[thermal]\nconductivity = 80\nspecific_heat = 500\ninitial = 300\n");
  }
};

TEST_F(SteadyPotentials, AreSolvedForOnceForEachInputOrAsConductivitiesMove) {
  EXPECT_EQ(row("1e5").skips.back().because, "it is steady: solved for once for each of its inputs");
  EXPECT_EQ(
      row("{ law = \"linear\", value = 1e5, coefficient = 1e-3, reference = 300 }").skips.back().because,
      "it is steady: solved for when conductivities have moved");
}

/// Of two fields one may have nothing left to step: which one is said, and a steady potential needs nothing.
TEST_F(SteadyPotentials, MayHaveNoParticleBetweenTheirElectrodes) {
  folder_.write("pair.csv", "id,x,y,z,r\n1,0,0,0,1e-3\n2,0,0,1.9e-3,1e-3\n");
  const std::string transient = "\"transient\"\nspecific_capacity = 1e3";
  EXPECT_EQ(load(pair_of("\"steady\"", "")).rhs->size(), 2u);
  expect_refused(pair_of(transient, ""), "[electric] mode = \"transient\": every node is fixed");
  expect_refused(pair_of("\"steady\"", "fixed = [ { where = \"all\", value = 300.0 } ]\n"),
                 "every node is fixed");
}

/// Its heat goes with the square of time, and the exponential knows straight lines.
TEST_F(SteadyPotentials, ThatFollowTimeAreNotForTheExponentialWhichSaysSo) {
  const Scene scene = row("1e5");
  Plan plan;
  plan.output_times = {scene.t_end};
  plan.ranges = {scene.fields.back().range_of_state()};
  const auto message =
      test::message_of<Refused>([&] { make_integrator("exponential")->prepare(*scene.rhs, plan); });
  EXPECT_NE(message.find("a steady one only where its inputs do not change in time"), std::string::npos)
      << message;
}

}  // namespace
}  // namespace superstep
