/// sts:n=auto keeps its tolerance whatever the inputs do: it once looked at the first output time alone.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.hpp"
#include "whole_cases.hpp"

namespace superstep {
namespace {

/// A lattice of which one side is switched between 300 and 310 K every half second, seen late.
test::Tree switched() {
  test::Tree times = {0.0}, values = {300.0};
  for (int k = 1; k <= 40; ++k) {
    times.insert(times.end(), {0.5 * k, 0.5 * k});
    values.insert(values.end(), {k % 2 ? 300.0 : 310.0, k % 2 ? 310.0 : 300.0});
  }
  test::Tree tree = {{"t_end", 20.0}, {"output_times", {10.2, 20.0}}};
  tree["packing"] = {{"file", "lattice.csv"}, {"length_unit", "mm"}};
  tree["material"] = {{"density", 1000.0}};
  tree["contact"] = {{"neck", "geometric"}};
  tree["thermal"] = {{"conductivity", 1.0}, {"specific_heat", 100.0}, {"initial", 300.0}};
  tree["thermal"]["fixed"] =
      test::Tree::array({{{"where", "top"}, {"value", {{"times", times}, {"values", values}}}},
                         {{"where", "bottom"}, {"value", 300.0}}});
  return tree;
}

TEST(ToleranceOfSts, IsKeptWhereInputsAreSwitched) {
  const test::CaseFolder folder;
  (void)test::whole_cases(folder);
  const std::string file = folder.write("switched.toml", test::toml_text(switched()).text);
  const auto said = test::call_program({"bench", file, "--integrator", "sts:n=auto,rtol=1e-2", "--integrator",
                                        "sts:n=auto,rtol=1e-3", "--integrator", "sts:n=auto,rtol=1e-4",
                                        "--repetitions", "1", "--quiet", "--out", folder.file("out")});
  ASSERT_EQ(said.code, 0) << said.err;
  const auto results = nlohmann::json::parse(folder.read("out/results.json"));
  double last = 1e300;
  int judged = 0;
  for (const auto& row : results.at("cases")[0].at("rows")) {
    if (row.at("integrator") != "sts") continue;
    ++judged;
    EXPECT_EQ(row.at("status"), "ok") << row;
    EXPECT_LT(row.at("delivered").get<double>(), 1) << row;
    EXPECT_LT(row.at("error_rms").get<double>(), last) << row;
    last = row.at("error_rms").get<double>();
  }
  EXPECT_EQ(judged, 3);
}

}  // namespace
}  // namespace superstep
