/// Rows in layers of a packing, or as the nodes of a network stand in their file, and rows of small
/// bandwidth: two orders of one scene, lone spheres and clusters in which nothing happens included.

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

class NetworkOrder : public test::CaseTexts {
 protected:
  /// A crooked chain, a pair that is at rest, a lone node, and one of capacity 0 beside the chain.
  void SetUp() override {
    std::string nodes = "id,capacity,source,initial,fixed\n", edges = "i,j,conductance\n";
    for (int k = 0; k < 40; ++k)
      nodes += fmt::format("{},{},{},{},{}\n", 7 * k % 40, k == 12 ? 0 : 1 + 0.1 * (k % 5), k == 20 ? 0.4 : 0,
                           5 + 0.5 * (k % 4), 7 * k % 40 == 0 ? "9" : "");
    for (int k = 0; k < 36; ++k) edges += fmt::format("{},{},{}\n", k, k + 1, 1 + 0.2 * (k % 3));
    folder_.write("nodes.csv", nodes + "100,1,0,5,\n101,1,0,5,\n102,1,0,7,\n");
    folder_.write("edges.csv", edges + "0,20,0.5\n100,101,1\n3,9,0.1\n9,3,0.2\n");
  }
  void expect_same(const std::string& more) {
    const auto scene = [&](const char* order) {
      return load(
          fmt::format("t_end = 5.0\nprobe = [12, 100]\n[network]\nnodes = \"nodes.csv\"\n"
                      "edges = \"edges.csv\"\norder = \"{}\"\n{}",
                      order, more));
    };
    const Scene in_order = scene("file"), as_usual = scene("bandwidth");
    EXPECT_TRUE(in_order.fields.front().in_order);
    EXPECT_FALSE(as_usual.fields.front().in_order);
    const auto& row_of_node = in_order.fields.front().row_of_node;
    std::int32_t row = 0;
    for (std::size_t node = 0; node < row_of_node.size(); ++node) {
      const bool is_row = node != 12 && !in_order.fields.front().graph.is_fixed[node];
      EXPECT_EQ(row_of_node[node], is_row ? row++ : -1) << node;
    }
    const auto a = test::values_at_end(in_order), b = test::values_at_end(as_usual);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-6) << k;
  }
};

TEST_F(NetworkOrder, ChangesNoTemperature) {
  expect_same("");
}

TEST_F(NetworkOrder, ChangesNoPotentialThatListsMove) {
  expect_same(
      "field = \"potential\"\nfixed = [ { ids = [30], value = { times = [0, 2, 2], values = [5, 7, 1] } } ]\n"
      "source = [ { ids = [8, 102], value = 0.25 } ]\n");
}

TEST_F(NetworkOrder, IsOneOfTwo) {
  expect_refused("t_end = 1\n[network]\nnodes = \"nodes.csv\"\nedges = \"edges.csv\"\norder = \"files\"\n",
                 "it must be \"bandwidth\" or \"file\"");
}

}  // namespace
}  // namespace superstep
