/// Cases that take networks as people have them: matrices, edges, tables of nodes.

#include <fmt/format.h>

#include "support/case_texts.hpp"

namespace superstep {
namespace {

using test::values_at_end;

class NetworkInputs : public test::CaseTexts {};

TEST_F(NetworkInputs, MatricesEdgeListsAndNodesWithoutCapacity) {
  // A chain held at 0 and 8: 1 - 2 - 3 - 4, where 2 has no capacity, so that 1 and 3 are joined by 1 W/K.
  folder_.write("K.mtx", "%%MatrixMarket matrix coordinate real symmetric\n4 4 3\n2 1 2\n3 2 2\n4 3 1\n");
  folder_.write("c.txt", "1\n0\n1\n1\n");
  const std::string head = "t_end = 50\n[network]\nmatrix = \"K.mtx\"\ncapacity = \"c.txt\"\n";
  const auto scene =
      load(head + "fixed = [ { ids = [1], value = 0.0 }, { ids = [4], value = 8.0 } ]\ninitial = 1.0\n");
  EXPECT_EQ(scene.rhs->size(), 1u);
  const auto value = values_at_end(scene);
  EXPECT_NEAR(value[2], 4, 1e-6);
  EXPECT_NEAR(value[1], 2, 1e-6) << "recovered from its neighbours";
  expect_refused("probe = 2\n" + head + "fixed = [ { ids = [1], value = 0.0 } ]\n", "has capacity 0");
  const auto driven = load(head + "source = { times = [0, 1], values = [0, 4] }\n");
  EXPECT_EQ(driven.fields[0].graph.tabled_sources.size(), 5u) << "that of 2 goes to its two neighbours";
  folder_.write("e.txt", "1 2 2\n2 3 2\n3 4 0.5\n3 4 0.5\n");
  folder_.write("f.csv", "id,value\n1,0\n4,8\n");
  const auto list =
      load("t_end = 50\n[network]\nedges = \"e.txt\"\ncapacity = \"c.txt\"\nfixed = \"f.csv\"\n");
  EXPECT_NEAR(values_at_end(list)[2], 4, 1e-6);
  EXPECT_FALSE(list.warnings.empty()) << "parallel edges are summed and said";
  expect_refused("t_end = 1\n[network]\nedges = \"e.txt\"\n", "'capacity' is missing, and edges have no");
  folder_.write("m.mtx", "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 2\n2 1 -1\n2 2 1\n");
  folder_.write("net.csv", "throat.conns[0],throat.conns[1],throat.g,pore.coords[0]\n0,1,2.0,0\n,,,1\n");
  for (const char* network :
       {"matrix = \"m.mtx\"\n", "openpnm = \"net.csv\"\nconductance = \"throat.g\"\n"}) {
    const Scene plain = load(std::string("t_end = 1\n[network]\n") + network);
    EXPECT_EQ(plain.fields[0].graph.capacity[0], 1);
    std::string notes;
    for (const auto& note : plain.warnings) notes += note + "\n";
    EXPECT_NE(notes.find("every node has 1"), std::string::npos) << notes;
  }
  expect_refused("t_end = 1\n[network]\nedges = \"e.txt\"\nmatrix = \"K.mtx\"\n", "give one of");
}

/// A current that is fed into one node of a network, however that comes: 1 - 2 - 3 with 1 held, from rest.
TEST_F(NetworkInputs, SourcesAtChosenNodesMayFollowTime) {
  folder_.write("e.csv", "i,j,conductance\n1,2,1\n2,3,1\n");
  folder_.write("K.mtx", "%%MatrixMarket matrix coordinate real symmetric\n3 3 2\n2 1 1\n3 2 1\n");
  const std::string step =
      "source = [ { ids = [3], value = { times = [0, 1, 1], values = [9, 9, 2] } }, "
      "{ ids = [2, 3], value = 0.5 } ]\n";
  const std::string files = "nodes = \"n.csv\"\nedges = \"e.csv\"\n";
  for (const double offset : {0.0, 300.0}) {
    const auto scene = [&](double t_end, const std::string& network, const std::string& more) {
      return load(
          fmt::format("t_end = {}\n[network]\n{}fixed = [ {{ ids = [1], value = {{ times = [0, 30], "
                      "values = [{}, {}] }} }} ]\n{}{}",
                      t_end, network, offset + 7, offset, step, more));
    };
    folder_.write(
        "n.csv",
        fmt::format("id,capacity,source,initial,fixed\n1,1,0,{0},\n2,1,0.25,{0},\n3,1,0,{0},\n", offset));
    // In the end 2.5 W enter at 3 and 0.5 W at 2; with the table of nodes 0.25 W there as well.
    const auto listed = values_at_end(scene(200, files, ""));
    EXPECT_NEAR(listed[1] - offset, 3.25, 1e-6);
    EXPECT_NEAR(listed[2] - offset, 5.75, 1e-6);
    for (const std::string network : {"matrix = \"K.mtx\"\n", "edges = \"e.csv\"\ncapacity = 1\n"}) {
      const std::string start = fmt::format("initial = {}\n", offset);
      const auto value = values_at_end(scene(200, network, start));
      EXPECT_NEAR(value[1] - offset, 3, 1e-6);
      EXPECT_NEAR(value[2] - offset, 5.5, 1e-6);
      // On either side of the step, where 3 gains what enters it and what comes from 2.
      const auto before = values_at_end(scene(1 - 1e-3, network, start)),
                 at = values_at_end(scene(1, network, start)),
                 behind = values_at_end(scene(1 + 1e-3, network, start));
      const double from_2 = at[1] - at[2];
      EXPECT_NEAR((at[2] - before[2]) / 1e-3, 9.5 + from_2, 0.02);
      EXPECT_NEAR((behind[2] - at[2]) / 1e-3, 2.5 + from_2, 0.02);
    }
  }
  const std::string begin = "t_end = 200\n[network]\n", held = "fixed = [ { ids = [1], value = 0 } ]\n";
  const std::string nodes = begin + files;
  expect_refused(nodes + held + "source = [ { ids = [1], value = 1 } ]\n", "node 1 is fixed: a source there");
  expect_refused(nodes + "source = [ { ids = [4], value = 1 } ]\n", "ids run from 1 to 3");
  expect_refused(nodes + "source = [ { ids = [2, 3, 2], value = 1 } ]\n", "it stands twice");
  expect_refused(nodes + "source = []\n", "at least one entry");
  expect_refused(nodes + "source = 1.0\n", "nodes has a column of that name");
  expect_refused(nodes + "fixed = \"f.csv\"\n", "nodes has a column of that name");
  expect_refused(nodes + "initial = 1.0\n", "initial");
}

TEST_F(NetworkInputs, SurroundingsOfALaplacianDrawTheNetworkToTheirValue) {
  folder_.write("K.mtx", "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 3\n2 1 -2\n2 2 2\n");
  const auto scene = load("t_end = 200\n[network]\nmatrix = \"K.mtx\"\ncapacity = 1.0\nambient = 7.0\n");
  for (const double value : values_at_end(scene)) EXPECT_NEAR(value, 7, 1e-6);
}

/// As pores on the boundary of a network have none.
TEST_F(NetworkInputs, AHeldNodeNeedsNoCapacity) {
  folder_.write("e.csv", "i,j,conductance\n1,2,1\n2,3,2\n3,4,1\n");
  const auto value = [&](const std::string& of_held, const std::string& of_3) {
    folder_.write("c.txt", of_held + "\n1\n" + of_3 + "\n" + of_held + "\n");
    const auto scene = load(
        "t_end = 0.7\n[network]\nedges = \"e.csv\"\ncapacity = \"c.txt\"\ninitial = 5.0\n"
        "fixed = [ { ids = [1], value = 300.0 }, { ids = [4], value = { times = [0, 1], values = [0, 8] } } "
        "]\n");
    return values_at_end(scene);
  };
  for (const char* of_3 : {"1", "0"})
    EXPECT_EQ(value("0", of_3), value("1", of_3)) << "with a capacity of " << of_3 << " beside it";
  folder_.write("c.txt", "0\n1\n-1\n0\n");
  expect_refused("t_end = 1\n[network]\nedges = \"e.csv\"\ncapacity = \"c.txt\"\n", "must be >= 0");
}

/// It would start from 0.
TEST_F(NetworkInputs, AFileOfInitialValuesForgetsNoNode) {
  folder_.write("e.csv", "i,j,conductance\n1,2,1\n2,3,1\n");
  const std::string network = "t_end = 1\n[network]\nedges = \"e.csv\"\ncapacity = 1\n";
  folder_.write("i.csv", "id,value\n1,300\n3,300\n");
  expect_refused(network + "initial = \"i.csv\"\n", "no value for node 2");
  EXPECT_EQ(load(network + "initial = \"i.csv\"\nfixed = [ { ids = [2], value = 5.0 } ]\n")
                .fields[0]
                .graph.initial[0],
            300);
  folder_.write("i.txt", "300\nnan\n300\n");
  expect_refused(network + "initial = \"i.txt\"\n", "no value for node 2");
  folder_.write("i.mtx", "%%MatrixMarket matrix coordinate real general\n3 1 1\n1 1 300\n");
  EXPECT_EQ(load(network + "initial = \"i.mtx\"\n").fields[0].graph.initial[1], 0)
      << "what is not stored is 0";
}

}  // namespace
}  // namespace superstep
