/// Rows in layers of the packing and rows of small bandwidth: two orders of one scene, lone spheres included.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "support/case_texts.hpp"

namespace superstep {
namespace {

class RowOrder : public test::CaseTexts {
 protected:
  /// A crooked row along x whose rows of the file stand in disorder, and three spheres that touch nobody.
  void write_row() {
    std::string rows = "id,x,y,z,radius\n";
    for (int k = 0; k < 40; ++k) {
      const int place = 7 * k % 40;
      rows += fmt::format("{},{},{},{},{}\n", 100 - place, 0.9 * place, 0.1 * (place % 3), 0.05 * (place % 2),
                          0.5 + 0.01 * (place % 5));
    }
    folder_.write("row.csv", rows + "-1,3,9,0,0.5\n-2,20,9,9,0.5\n-3,80,0,0,0.5\n");
  }
  std::map<std::int64_t, double> values(const std::string& tables, const std::string& order,
                                        std::size_t field) {
    const Scene scene =
        load(fmt::format("t_end = 5.0\n[packing]\nfile = \"row.csv\"\nlength_unit = \"mm\"\norder = \"{}\"\n"
                         "[material]\ndensity = 5000\n[contact]\nneck = \"hertz\"\n{}",
                         order, tables));
    EXPECT_EQ(scene.fields.front().in_order, order == "layers");
    const auto at_end = test::values_at_end(scene, field);
    std::map<std::int64_t, double> out;
    for (std::size_t k = 0; k < at_end.size(); ++k) out[scene.fields[field].graph.id[k]] = at_end[k];
    return out;
  }
  void expect_same(const std::string& tables, std::size_t field, double tolerance) {
    const auto in_layers = values(tables, "layers", field), as_usual = values(tables, "bandwidth", field);
    ASSERT_EQ(in_layers.size(), 43u);
    ASSERT_EQ(as_usual.size(), in_layers.size());
    double low = as_usual.begin()->second, high = low;
    for (const auto& [id, value] : as_usual) {
      EXPECT_NEAR(in_layers.at(id), value, tolerance) << id;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    EXPECT_GT(high - low, 1e3 * tolerance) << "something happens";
  }
  void SetUp() override { write_row(); }

  // From rest, on an offset, with a bend and a step.
  const std::string ramp_ =
      "fixed = [ { where = { ids = [100] }, value = { times = [0, 1, 1, 4], values = [300, 400, 350, 500] } "
      "} ]\n";
};

TEST_F(RowOrder, ChangesNoTemperature) {
  expect_same("[thermal]\nconductivity = 60.0\nspecific_heat = 400\ninitial = 300\n" + ramp_, 0, 1e-5);
}

TEST_F(RowOrder, ChangesNoTemperatureThatALawFollows) {
  expect_same(
      "[thermal]\nconductivity = { law = \"linear\", value = 60, coefficient = 2e-3, reference = 300 }\n"
      "specific_heat = 400\ninitial = 300\n" +
          ramp_ + "radiation = [ { where = \"all\", emissivity = 0.8, ambient = 280 } ]\n",
      0, 1e-5);
}

TEST_F(RowOrder, ChangesNeitherOfTwoFields) {
  const std::string both =
      "[electric]\nmode = \"transient\"\nspecific_capacity = 1e5\n"
      "conductivity = { law = \"sigmoid\", value = 1e4, amplitude = 1.5, steepness = 0.05, reference = 320 "
      "}\n"
      "fixed = [ { where = { ids = [100] }, value = 0.5 }, { where = { ids = [61] }, value = 0.0 } ]\n"
      "[thermal]\nconductivity = 60.0\nspecific_heat = 400\ninitial = 300\n" +
      ramp_;
  expect_same(both, 0, 1e-6);
  expect_same(both, 1, 1e-4);
}

}  // namespace
}  // namespace superstep
