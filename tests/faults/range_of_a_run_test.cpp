/// What no temperature can be is no result of `run`, from rest, on an offset, and with an input that moves.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

/// A rod between two held ends, from rest on `offset`; supersteps that hardly damp leave what lies between
/// them.
class RangeOfARun : public ::testing::TestWithParam<double> {
 protected:
  test::Said run(const std::string& spec) {
    return test::call_program(
        {"run", folder_.file("rod.toml"), "--integrator", spec, "--out", folder_.file("out")});
  }
  void write(const std::string& more) {
    std::string nodes = "id,capacity,source,initial,fixed\n", edges = "i,j,conductance\n";
    for (int id = 1; id <= 20; ++id) {
      const bool is_end = id == 1 || (id == 20 && more.empty());
      nodes += fmt::format("{},1,0,{},{}\n", id, GetParam(),
                           is_end ? fmt::format("{}", GetParam() + (id == 1 ? 0 : 10)) : "");
      if (id > 1) edges += fmt::format("{},{},1\n", id - 1, id);
    }
    folder_.write("nodes.csv", nodes);
    folder_.write("edges.csv", edges);
    folder_.write("rod.toml",
                  "t_end = 100.0\noutput_times = [10.0, 50.0, 100.0]\n[network]\nnodes = \"nodes.csv\"\n"
                  "edges = \"edges.csv\"\n" +
                      more);
  }
  /// The end that is moved up and down by 10.
  [[nodiscard]] static std::string moved_end() {
    return fmt::format(
        "fixed = [ {{ ids = [20], value = {{ times = [0, 30, 30], values = [{0}, {1}, {0}] }} }} ]\n",
        GetParam(), GetParam() + 10);
  }
  test::CaseFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(Offsets, RangeOfARun, ::testing::Values(0.0, 300.0));

TEST_P(RangeOfARun, IsLeftByNobodyWhoIsOk) {
  write("");
  for (const char* spec : {"sts:n=40,nu=1e-5", "trapezoidal:step=50"}) {
    const auto said = run(spec);
    EXPECT_EQ(said.code, 4) << spec << ": " << said.out << said.err;
    EXPECT_NE(said.out.find("inaccurate: the temperature leaves the range"), std::string::npos) << said.out;
    const auto record = nlohmann::json::parse(folder_.read("out/run.json"));
    EXPECT_EQ(record.at("outcome").at("status"), "inaccurate") << spec;
  }
  for (const char* spec : {"sts:n=5,nu=0.05", "trapezoidal:rtol=1e-3", "auto"})
    EXPECT_EQ(run(spec).code, 0) << spec;
}

/// The range is that of a whole table.
TEST_P(RangeOfARun, HoldsWhatAnInputReaches) {
  write(moved_end());
  for (const char* spec : {"sts:n=5,nu=0.05", "rkc:rtol=1e-3", "auto"}) {
    const auto said = run(spec);
    EXPECT_EQ(said.code, 0) << spec << ": " << said.out << said.err;
  }
  EXPECT_EQ(run("sts:n=60,nu=1e-6").code, 4);
}

}  // namespace
}  // namespace superstep
