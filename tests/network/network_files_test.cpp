/// Networks as matrices, edge lists and pore networks.

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "network/files/matrix_market.hpp"
#include "network/files/read_network.hpp"
#include "network/files/recognise_network.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

class NetworkFiles : public testing::Test {
 protected:
  NetworkInput matrix(const std::string& content, MatrixKind kind = MatrixKind::automatic,
                      double ambient = 0) {
    return read_matrix_network(folder_.write("K.mtx", content), kind, ambient);
  }
  std::string refusal(const std::string& content, MatrixKind kind = MatrixKind::automatic) {
    return test::message_of<InputError>([&] { (void)matrix(content, kind); });
  }
  void expect_refused(const std::string& content, const std::string& part,
                      MatrixKind kind = MatrixKind::automatic) {
    const auto message = refusal(content, kind);
    EXPECT_NE(message.find(part), std::string::npos) << "wanted: " << part << "\n   got: " << message;
  }
  static void expect_chain(const Graph& graph) {
    ASSERT_EQ(graph.nodes(), 3u);
    EXPECT_EQ(graph.i, (std::vector<std::int32_t>{0, 1}));
    EXPECT_EQ(graph.j, (std::vector<std::int32_t>{1, 2}));
    EXPECT_EQ(graph.conductance, (std::vector<double>{2, 3}));
  }
  test::TemporaryFolder folder_;
  const std::string symmetric_ = "%%MatrixMarket matrix coordinate real symmetric\n";
  const std::string general_ = "%%MatrixMarket matrix coordinate real general\n";
};

TEST_F(NetworkFiles, LaplaciansAndTablesOfConductancesAreToldApart) {
  expect_chain(matrix(symmetric_ + "% a comment\n3 3 5\n1 1 2\n2 1 -2\n2 2 5\n3 2 -3\n3 3 3\n").graph);
  expect_chain(matrix(symmetric_ + "3 3 2\n2 1 2\n3 2 3\n").graph);
  expect_chain(matrix(general_ + "3 3 4\n1 2 2\n2 1 2\n2 3 3\n3 2 3\n").graph);
  expect_chain(
      matrix("%%MatrixMarket matrix array integer general\n3 3\n2\n-2\n0\n-2\n5\n-3\n0\n-3\n3\n").graph);
  EXPECT_EQ(matrix(symmetric_ + "3 3 2\n2 1 2\n3 2 3\n").graph.id, (std::vector<std::int64_t>{1, 2, 3}));
}

TEST_F(NetworkFiles, WhatAMatrixIsIsSaidWhereItIsGuessedAlone) {
  for (const auto& [content, kind] :
       {std::pair(symmetric_ + "2 2 3\n1 1 2\n2 1 -2\n2 2 2\n", MatrixKind::laplacian),
        {symmetric_ + "2 2 1\n2 1 2\n", MatrixKind::conductance}}) {
    EXPECT_EQ(matrix(content).notes.size(), 1u);
    EXPECT_TRUE(matrix(content, kind).notes.empty());
  }
}

TEST_F(NetworkFiles, WhatARowSumsToLeadsToSurroundings) {
  const auto input = matrix(symmetric_ + "2 2 3\n1 1 2.5\n2 1 -2\n2 2 2\n", MatrixKind::automatic, 300);
  ASSERT_EQ(input.graph.convection.size(), 1u);
  EXPECT_EQ(input.graph.convection[0].node, 0);
  EXPECT_EQ(input.graph.convection[0].coefficient, 0.5);
  EXPECT_EQ(input.graph.convection[0].ambient, 300);
  EXPECT_EQ(input.notes.size(), 2u);
}

TEST_F(NetworkFiles, ALastNumberWithoutAnEndIsSaid) {
  const std::string whole = symmetric_ + "3 3 2\n2 1 12.5\n3 2 12.5";
  const auto cut = matrix(whole.substr(0, whole.size() - 2));
  ASSERT_EQ(cut.notes.size(), 2u);
  EXPECT_NE(cut.notes[1].find("its last line has no end"), std::string::npos) << cut.notes[1];
  EXPECT_EQ(matrix(whole + "\n").notes.size(), 1u);
}

TEST_F(NetworkFiles, BadMatricesAreRefusedByEntry) {
  expect_refused(general_ + "3 3 3\n1 2 2\n2 1 2\n2 3 3\n", "entry (2, 3) is 3; the entry across");
  expect_refused(general_ + "2 2 2\n1 2 2\n2 1 2.1\n", "symmetric");
  expect_refused(symmetric_ + "2 2 3\n1 1 1\n2 1 -2\n2 2 2\n", "row 1 of the Laplacian sums to -1");
  expect_refused(symmetric_ + "3 3 3\n2 1 -2\n3 2 3\n1 1 2\n", "off the diagonal a Laplacian holds -K");
  expect_refused(symmetric_ + "2 2 1\n2 1 -2\n", "conductance must be >= 0", MatrixKind::conductance);
  expect_refused(symmetric_ + "2 2 2\n2 1 -2\n", "ends after 1 entries");
  expect_refused(symmetric_ + "2 2 1\n2 1 -2\n2 2 1\n", "K.mtx:4: has more rows");
  expect_refused(symmetric_ + "2 2 1\n3 1 -2\n", "K.mtx:3: position '3'");
  expect_refused(symmetric_ + "2000000000 2000000000 1\n2 1 2\n", "most nodes touch nothing");
  expect_refused(symmetric_ + "2 2 1\n2 1 x\n", "entry is 'x'");
  expect_refused("%%MatrixMarket matrix coordinate complex general\n1 1 0\n", "'complex'");
  expect_refused("%%MatrixMarket matrix coordinate real hermitian\n1 1 0\n", "'hermitian'");
  expect_refused(general_ + "2 3 0\n", "2 by 3");
  expect_refused(general_ + "-2 2 0\n", "counts");
}

TEST_F(NetworkFiles, ASymmetricMatrixIsStoredInOneTriangle) {
  expect_chain(matrix(symmetric_ + "3 3 2\n1 2 2\n2 3 3\n").graph);
  expect_chain(matrix(symmetric_ + "3 3 2\n1 2 2\n3 2 3\n").graph);
  expect_chain(matrix(symmetric_ + "3 3 3\n2 1 0.5\n2 1 1.5\n3 2 3\n").graph);
  expect_refused(symmetric_ + "3 3 4\n2 1 2\n3 2 3\n1 2 2\n2 3 3\n",
                 "K.mtx:5: entry (1, 2) is 2; the entry across the diagonal stands there, too");
}

TEST_F(NetworkFiles, WrittenMatricesReadBack) {
  const std::vector<MatrixMarket::Entry> lower = {{0, 0, 2.25, 0}, {1, 0, -2.25, 0}, {1, 1, 2.25, 0}};
  const auto again = matrix(matrix_market_text(2, lower, "a comment")).graph;
  EXPECT_EQ(again.conductance, std::vector<double>{2.25});
  const std::vector<double> vector = {1.5, -2, 0};
  const auto read = read_matrix_market(folder_.write("v.mtx", matrix_market_text(vector, "of it")));
  ASSERT_EQ(read.entries.size(), 3u);
  EXPECT_EQ(read.entries[1].value, -2);
}

TEST_F(NetworkFiles, EdgeListsOfAnyTableAndParallelEdges) {
  for (const char* text : {"7 9 2\n9 12 3\n", "i j conductance\n7 9 2\n9 12 3\n",
                           "I;J;Conductance\n7;9;2\n9;12;3\n", "# a list\n7\t9\t2\n12\t9\t3\n"}) {
    const auto input = read_edge_list(folder_.write("e.txt", text));
    expect_chain(input.graph);
    EXPECT_EQ(input.graph.id, (std::vector<std::int64_t>{7, 9, 12}));
    EXPECT_TRUE(input.notes.empty());
  }
  const auto joined = read_edge_list(folder_.write("e.txt", "1 2 0.5\n3 2 3\n2 1 1.5\n"));
  expect_chain(joined.graph);
  EXPECT_EQ(joined.notes.size(), 1u) << "summing is said";
}

TEST_F(NetworkFiles, ProseAboveEdgesIsNoHeader) {
  for (const char* head :
       {"# my edge list\n", "# i j conductance\n# my edge list\n", "# i,j,conductance\n"}) {
    const auto file = recognise_network(folder_.write("e.txt", std::string(head) + "1 2 2\n2 3 3\n"));
    ASSERT_TRUE(file) << head;
    expect_chain(file->input.graph);
  }
}

TEST_F(NetworkFiles, PoreNetworksJoinPoresByThroats) {
  const std::string csv =
      "pore.coords[0],pore.coords[1],pore.coords[2],pore.left,pore.volume,throat.conns[0],throat.conns[1],"
      "throat.diffusive_conductance\n"
      "0.0,0,0,True,1e-9,0.0,1.0,2\n1.0,0,0,False,2e-9,1,2,3\n2.0,0,0,False,3e-9,,,\n";
  const auto pores =
      read_openpnm(folder_.write("net.csv", csv), "throat.diffusive_conductance", "pore.volume");
  expect_chain(pores.input.graph);
  EXPECT_EQ(pores.input.graph.capacity[2], 3e-9);
  ASSERT_EQ(pores.labels.size(), 1u);
  EXPECT_EQ(pores.labels[0].first, "pore.left");
  EXPECT_EQ(pores.labels[0].second, (std::vector<char>{1, 0, 0}));
  EXPECT_NE(test::message_of<InputError>([&] {
              (void)read_openpnm(folder_.file("net.csv"), "throat.k", "");
            }).find("'throat.k'"),
            std::string::npos);
}

/// What stands below a gap would have another number, or join other pores.
TEST_F(NetworkFiles, PoreNetworksHaveNoGapsAboveTheirPadding) {
  const auto refusal = [&](const std::string& rows) {
    const std::string file = folder_.write(
        "net.csv", "pore.coords[0],pore.volume,throat.conns[0],throat.conns[1],throat.k\n" + rows);
    return test::message_of<InputError>([&] { (void)read_openpnm(file, "throat.k", "pore.volume"); });
  };
  EXPECT_EQ(refusal("0,1,0,1,2\n1,1,1,2,3\n2,1,,,\n"), "");
  EXPECT_NE(refusal("0,1,0,1,2\n,,1,2,3\n2,1,,,\n3,1,,,\n").find("net.csv:4: column 'pore.coords[0]'"),
            std::string::npos);
  EXPECT_NE(refusal("0,1,0,1,2\n1,1,1,2,3\nnan,1,,,\n").find("net.csv:4: column 'pore.volume' is '1'"),
            std::string::npos);
  EXPECT_NE(refusal("0,1,nan,1,2\n1,1,1,2,3\n2,1,,,\n").find("net.csv:2: column 'throat.conns[1]' is '1'"),
            std::string::npos);
  EXPECT_NE(refusal("0,1,,,\n1,1,1,2,3\n2,1,,,\n").find("net.csv:3: column 'throat.conns[0]'"),
            std::string::npos);
}

/// What OpenPNM writes for ParaView: names with bars, labels as integers, arrays divided by tabs.
std::string pores_for_paraview(const std::string& lines, const std::string& offsets = "2\t4") {
  return "<?xml version=\"1.0\" ?>\n"
         "<VTKFile byte_order=\"LittleEndian\" type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
         "<Piece NumberOfLines=\"2\" NumberOfPoints=\"3\">\n<Points><DataArray Name=\"coords\" "
         "NumberOfComponents=\"3\" type=\"Float64\">0.0\t0.0\t0.0\t1.0\t0.0\t0.0\t2.0\t0.0\t0.0</DataArray>\n"
         "</Points>\n<Lines><DataArray Name=\"connectivity\" NumberOfComponents=\"1\" type=\"Int64\">" +
         lines + "</DataArray>\n<DataArray Name=\"offsets\" NumberOfComponents=\"1\" type=\"Int64\">" +
         offsets +
         "</DataArray>\n</Lines>\n<PointData>"
         "<DataArray Name=\"net | labels | pore.left\" NumberOfComponents=\"1\" "
         "type=\"Int64\">1\t0\t0</DataArray>\n"
         "<DataArray Name=\"net | properties | pore | volume\" NumberOfComponents=\"1\" "
         "type=\"Float64\">1e-09\t2e-09\t3e-09</DataArray>\n</PointData>\n<CellData>"
         "<DataArray Name=\"air | throat.diffusive_conductance\" NumberOfComponents=\"1\" "
         "type=\"Float64\">2.0\t3.0</DataArray>\n</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

TEST_F(NetworkFiles, PoreNetworksForParaViewReadAsTheirTables) {
  const auto pores = read_openpnm(folder_.write("net.vtp", pores_for_paraview("0\t1\t1\t2")),
                                  "throat.diffusive_conductance", "pore.volume");
  expect_chain(pores.input.graph);
  EXPECT_EQ(pores.input.graph.capacity[2], 3e-9);
  ASSERT_EQ(pores.labels.size(), 1u);
  EXPECT_EQ(pores.labels[0].first, "pore.left");
  EXPECT_EQ(pores.labels[0].second, (std::vector<char>{1, 0, 0}));
}

/// Of two phases, as OpenPNM exports a project.
TEST_F(NetworkFiles, PoreNetworksSayWhichColumnIsMeant) {
  const std::string csv =
      "pore.coords[0],pore.volume,throat.conns[0],throat.conns[1],air.throat.k,water.throat.k\n"
      "0,1,0,1,2,4\n1,1,1,2,3,5\n2,-1,,,,\n";
  const std::string file = folder_.write("net.csv", csv);
  const auto refusal = [&](const std::string& conductance, const std::string& capacity) {
    return test::message_of<InputError>([&] { (void)read_openpnm(file, conductance, capacity); });
  };
  EXPECT_NE(refusal("throat.k", "").find("several are called 'throat.k': air.throat.k, water.throat.k"),
            std::string::npos);
  for (const char* whole : {"water.throat.k", "water | throat.k"})
    EXPECT_EQ(read_openpnm(file, whole, "").input.graph.conductance, (std::vector<double>{4, 5})) << whole;
  EXPECT_NE(refusal("air.throat.k", "pore.volume").find("net.csv:4: the capacity is -1"), std::string::npos);
}

TEST_F(NetworkFiles, PoreNetworksForParaViewAreLinesOfTwoPores) {
  const auto refusal = [&](const std::string& text, const std::string& conductance) {
    return test::message_of<InputError>(
        [&] { (void)read_openpnm(folder_.write("net.vtp", text), conductance, ""); });
  };
  const std::string name = "throat.diffusive_conductance";
  EXPECT_NE(refusal(pores_for_paraview("0 1 1 3"), name).find("joins point 3"), std::string::npos);
  EXPECT_NE(refusal(pores_for_paraview("0 1 1 1"), name).find("throat 1: throat joins pores 1 and 1"),
            std::string::npos);
  EXPECT_NE(refusal(pores_for_paraview("0 1 2 1", "3 4"), name).find("line 0 does not join two points"),
            std::string::npos);
  EXPECT_NE(refusal(pores_for_paraview("0 1 2", "3"), name).find("each line must join two"),
            std::string::npos);
  EXPECT_NE(refusal(pores_for_paraview("0 1 1 2"), "throat.k").find("it has air | throat.diffusive"),
            std::string::npos);
}

}  // namespace
}  // namespace superstep
