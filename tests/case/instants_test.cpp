/// Times that no method can compute with, wherever a case states them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "case/scene.hpp"
#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

/// Two nodes, the first of which is held at what is given.
class Instants : public ::testing::Test {
 protected:
  Instants() { folder_.write("e.csv", "i,j,conductance\n1,2,1\n"); }
  Scene load(const std::string& value, const std::string& times = "t_end = 2.0\n") {
    return load_scene(folder_.write(
        "case.toml",
        fmt::format(
            "{}[network]\nedges = \"e.csv\"\ncapacity = 1.0\nfixed = [ {{ ids = [1], value = {} }} ]\n",
            times, value)));
  }
  void refuses(const std::string& value, const std::string& says,
               const std::string& times = "t_end = 2.0\n") {
    const auto message = test::message_of<InputError>([&] { (void)load(value, times); });
    EXPECT_NE(message.find(says), std::string::npos) << message;
  }
  test::TemporaryFolder folder_;
};

TEST_F(Instants, OfTablesAreRefusedWithTheRange) {
  refuses(
      "{ times = [0, 1e-300], values = [0, 10] }",
      "'network.fixed[0].value.times' is an array; the instant 1e-300 s is beyond what can be computed with");
  refuses("{ times = [-1e-41, 1], values = [0, 10] }", "must lie between 1e-40 and 1e+40 s");
  refuses("{ times = [1e-30, 1.00000000001e-30], values = [0, 10] }",
          "between the instants 1e-30 and 1.00000000001e-30 s, the time");
  const Scene scene = load("{ times = [0, 1e-40, 1e-40, 1e40], values = [0, 1, 2, 3] }");
  EXPECT_EQ(scene.fields[0].graph.tables[0].time.size(), 4U) << "the ends of the range, and a step";
}

TEST_F(Instants, OfProfilesAreRefusedAtTheirLine) {
  folder_.write("p.csv", "time,value\n0,1\n1e-300,2\n");
  refuses("{ file = \"p.csv\" }", "p.csv:3: the instant 1e-300 s");
  folder_.write("p.csv", "time,value\n0,1\n1e41,2\n");
  refuses("{ file = \"p.csv\" }", "p.csv:3: the instant 1e+41 s");
}

/// Epoch seconds, or milliseconds: the run would see one value, and nobody would know.
TEST_F(Instants, ThatTheRunNeverReachesAreWarnedOf) {
  const auto said = [&](const std::string& value) {
    std::string all;
    for (const auto& warning : load(value).warnings) all += warning + "\n";
    return all;
  };
  EXPECT_NE(said("{ times = [1700000000, 1700000010], values = [300, 400] }")
                .find("holds from 1700000000 to 1700000010 s, and the run goes from 0 to 2 s: nothing in it "
                      "changes, it stays at 300"),
            std::string::npos);
  EXPECT_NE(said("{ times = [-5, -1], values = [300, 400] }").find("it stays at 400"), std::string::npos);
  EXPECT_NE(said("{ times = [3, 4], values = [300, 400], outside = \"zero\" }").find("it stays at 0"),
            std::string::npos);
  for (const char* table :
       {"{ times = [1, 5], values = [300, 400] }", "{ times = [2, 2], values = [300, 400] }",
        "{ times = [7], values = [300] }", "{ times = [7, 9], values = [300, 300] }",
        "{ times = [7, 8], values = [300, 400], period = 3 }"})
    EXPECT_EQ(said(table).find("nothing in it changes"), std::string::npos) << table;
}

TEST_F(Instants, OfOutputsAndTheEndAreRefusedAtTheirLine) {
  refuses("1.0", "case.toml:1: key 't_end' is 1e-41; the end 1e-41 s is beyond", "t_end = 1e-41\n");
  refuses("1.0", "case.toml:2: key 'output_times'", "t_end = 1\noutput_times = [1e-300, 1]\n");
}

}  // namespace
}  // namespace superstep
