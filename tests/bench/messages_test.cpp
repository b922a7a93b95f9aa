/// What commands say beside their results.

#include <gtest/gtest.h>

#include "support/program_fixture.hpp"

namespace superstep {
namespace {

using test::Program;

TEST_F(Program, CountsAgreeWithTheirNouns) {
  folder_.write("n.csv", "id,capacity,source,initial,fixed\n1,1,0,0,0\n2,1,0,1,\n3,1,0,0,\n4,1,0,1,\n");
  folder_.write("e.csv", "i,j,conductance\n1,2,1\n3,4,1\n");
  folder_.write("one.toml",
                "t_end = 0.1\nprobe = 2\n[network]\nnodes = \"n.csv\"\nedges = \"e.csv\"\n[bench]\n"
                "baseline = \"forward-euler:step=0.1\"\nintegrators = [\"forward-euler:step=0.1\"]\n");
  ASSERT_EQ(run("run one.toml --integrator forward-euler:step=0.1 --out one"), 0) << err();
  EXPECT_NE(out().find(", 1 step, 1 sweep, "), std::string::npos) << out();
  EXPECT_NE(err().find("1 cluster without a fixed temperature is integrated; what enters it stays"),
            std::string::npos)
      << err();
  ASSERT_EQ(run("info one.toml"), 0) << err();
  EXPECT_NE(out().find("t_end = 0.1 s, 1 output time, 1 probe\n"), std::string::npos) << out();
  EXPECT_NE(out().find("skipped: 1 fixed node because its value is known\n"), std::string::npos) << out();
  ASSERT_EQ(run("bench one.toml --repetitions 1 --reference none --out bench"), 0) << err();
  EXPECT_NE(out().find("4 nodes, 2 contacts, 3 unknowns, t_end 0.1 s; 1 repetition, 1 thread\n"),
            std::string::npos)
      << out();
  ASSERT_EQ(run("report bench --markdown"), 0) << err();
  EXPECT_TRUE(out().starts_with("**The run succeeded.**\n")) << out();
}

TEST_F(Program, InfoStatesNoBoundOfNuThatNothingMeets) {
  ASSERT_EQ(run("info rod.toml"), 0) << err();
  EXPECT_NE(out().find("STS asks for 0 < nu below it"), std::string::npos) << out();
  folder_.write("n.csv", "id,capacity,source,initial,fixed\n1,1,0,0,\n2,1,0,1,\n");
  folder_.write("e.csv", "i,j,conductance\n1,2,1\n");
  folder_.write("floats.toml", "t_end = 0.1\n[network]\nnodes = \"n.csv\"\nedges = \"e.csv\"\n");
  ASSERT_EQ(run("info floats.toml"), 0) << err();
  EXPECT_EQ(out().find("below it"), std::string::npos) << out();
  EXPECT_NE(out().find("lambda_min / lambda_max            0, where eq. 25"), std::string::npos) << out();
}

TEST_F(Program, RunSaysWhereTheStatesAtOutputTimesAre) {
  const auto says = [&](const std::string& arguments, const std::string& part) {
    EXPECT_EQ(run("run " + arguments), 0) << err();
    return err().find(part) != std::string::npos;
  };
  EXPECT_TRUE(says("rod.toml", "of the states at 3 output times final.csv keeps the last; the Python module"))
      << err();
  EXPECT_FALSE(says("rod.toml --quiet", "output times"));
  folder_.write("row.csv", "id,x,y,z,radius\n1,0,0,0.01,0.0102\n2,0,0,0.03,0.0102\n3,0,0,0.05,0.0102\n");
  const std::string rest =
      "t_end = 1\n[packing]\nfile = \"row.csv\"\n[material]\ndensity = 5000\n[contact]\nneck = \"hertz\"\n"
      "[thermal]\nconductivity = 50\nspecific_heat = 500\ninitial = 300.0\n"
      "fixed = [ { where = { ids = [1] }, value = 310.0 } ]\n";
  folder_.write("one.toml", rest);
  folder_.write("two.toml", "output_times = [0.5, 1]\n" + rest);
  EXPECT_FALSE(says("one.toml", "output times")) << err();
  EXPECT_TRUE(says("two.toml", "of the states at 2 output times final.csv keeps the last; --vtk writes"))
      << err();
  EXPECT_FALSE(says("two.toml --vtk", "output times")) << err();
}

}  // namespace
}  // namespace superstep
