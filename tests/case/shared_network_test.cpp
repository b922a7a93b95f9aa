/// Networks that processes read in parts, by one process that has all parts: what is built is what one
/// process builds as always.

#include <fmt/format.h>

#include "case/parts/build_in_parts.hpp"
#include "case/parts/own_nodes.hpp"
#include "support/case_texts.hpp"

namespace superstep {
namespace {

class SharedNetwork : public test::CaseTexts {
 protected:
  void SetUp() override {
    std::string nodes = "id,capacity,source,initial,fixed\n", edges = "i,j,conductance\n";
    for (int k = 0; k < 90; ++k)
      nodes += fmt::format("{},{},{},{},{}\n", id(k), 1 + k % 4, k == 70 ? 0.5 : 0, 20 + k % 3,
                           k % 31 == 0 ? "25" : "");
    for (int k = 0; k < 300; ++k)
      if (const int i = k * 37 % 60, j = k * k % 60; i != j)
        edges += fmt::format("{},{},{}\n", id(i), id(j), k % 20 ? 0.3 * (1 + k % 7) : 0);
    folder_.write("nodes.csv", nodes);
    folder_.write("edges.csv", edges);
  }
  static int id(int k) { return 7 * k % 90 - 40; }
  static std::string text(const std::string& more = "") {
    return "t_end = 2.0\nprobe = [-40, 9, 30]\n[network]\nnodes = \"nodes.csv\"\nedges = \"edges.csv\"\n"
           "order = \"file\"\n" +
           more;
  }
  TomlTable parse(const std::string& text) { return TomlTable::parse_file(folder_.write("c.toml", text)); }

  void expect_one_reader(const std::string& text, const std::string& why) {
    std::string why_not;
    EXPECT_FALSE(can_be_in_parts(parse(text), why_not)) << text;
    EXPECT_EQ(why_not, why);
  }
};

TEST_F(SharedNetwork, IsTheWholeOne) {
  const Scene whole = load(text());
  std::string why_not;
  ASSERT_TRUE(can_be_in_parts(parse(text()), why_not)) << why_not;
  const Scene parts = build_in_parts(parse(text()), world());
  ASSERT_EQ(parts.initial, whole.initial);
  EXPECT_EQ(parts.nodes(), whole.nodes());
  EXPECT_EQ(parts.edges(), whole.edges());
  EXPECT_EQ(parts.warnings, whole.warnings);
  ASSERT_EQ(parts.skips.size(), whole.skips.size());
  for (std::size_t k = 0; k < parts.skips.size(); ++k) {
    EXPECT_EQ(parts.skips[k].what, whole.skips[k].what);
    EXPECT_EQ(parts.skips[k].because, whole.skips[k].because);
  }
  EXPECT_EQ(parts.rhs->facts().pair_step, whole.rhs->facts().pair_step);
  const auto rate = [](const Scene& scene) {
    std::vector<double> out(scene.rhs->size());
    (*scene.rhs)(0.0, scene.initial, out);
    return out;
  };
  EXPECT_EQ(rate(parts), rate(whole));
  ASSERT_EQ(parts.probes.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(parts.probes[k].label, whole.probes[k].label);
    EXPECT_EQ(parts.entry_of_node(0, parts.probes[k].node), whole.entry_of_node(0, whole.probes[k].node));
  }
  std::size_t node = 0;
  const Graph& graph = whole.fields.front().graph;
  parts.own_nodes->show([&](const ShownNode& shown) {
    EXPECT_EQ(shown.id, graph.id[node]);
    EXPECT_EQ(shown.is_fixed, graph.is_fixed[node] != 0);
    EXPECT_EQ(shown.fixed_value, graph.fixed_value[node]);
    ++node;
  });
  EXPECT_EQ(node, graph.nodes());
}

TEST_F(SharedNetwork, WhatCannotBeSharedOneProcessReads) {
  expect_one_reader("t_end = 1\n[network]\nnodes = \"nodes.csv\"\nedges = \"edges.csv\"\n", "");
  expect_one_reader(text("source = [ { ids = [9], value = 1 } ]\n"), "[network] has source");
  expect_one_reader("t_end = 1\n[network]\ngenerator = \"grid\"\nsize = 100\norder = \"file\"\n",
                    "[network] has generator");
  expect_one_reader("t_end = 1\n[network]\nedges = \"edges.csv\"\ncapacity = 1\norder = \"file\"\n",
                    "[network] has no nodes");
  expect_one_reader(text("[published]\nlambda_max = 1\n"), "its case has [published]");
  folder_.write("edges.csv", "1,2,3\n");
  expect_one_reader(text(), "of edges.csv, no line of its own names its columns");
  folder_.write("edges.csv", "i,j,conductance\n1,2,3\n");
  folder_.write("nodes.csv", "id,capacity,source,initial,fixed\n1,1,0,0,\n2,0,0,0,\n");
  EXPECT_THROW((void)build_in_parts(parse("t_end = 1\n" + text().substr(text().find("[network]"))), world()),
               NeedsOneReader);
}

}  // namespace
}  // namespace superstep
