/// Tables of nodes and edges that are read in parts: parts together are the whole.

#include "network/files/network_rows.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "network/files/read_network.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

/// Rows with comments and blank lines between them; the last one may lack its end.
std::string table_of_nodes(std::size_t rows, const std::string& end, bool last_end) {
  std::string text = "# nodes" + end + "fixed;id;capacity;initial;source" + end;
  for (std::size_t k = 0; k < rows; ++k) {
    if (k % 7 == 3) text += "# a comment, and a long one at that" + end;
    if (k % 11 == 5) text += end;
    text += fmt::format("{};{};{};{};0.{}", k % 5 ? "" : "4.5", 1000 - 3 * static_cast<std::int64_t>(k),
                        1 + 0.1 * static_cast<double>(k % 9), k * k, k % 10);
    if (k + 1 < rows || last_end) text += end;
  }
  return text;
}

std::string table_of_edges(std::size_t nodes, const std::string& end, bool last_end) {
  std::string text = "i j conductance" + end;
  for (std::size_t k = 0; k + 1 < nodes; ++k) {
    if (k % 8 == 6) text += end + "% on" + end;
    text += fmt::format("{} {} {}", 1000 - 3 * static_cast<std::int64_t>(k),
                        1000 - 3 * static_cast<std::int64_t>(k + 1), 1 + k % 4);
    if (k + 2 < nodes || last_end) text += end;
  }
  return text;
}

template <class Row, class Read>
std::vector<Row> together(const RowsInParts& table, std::uint64_t parts, const Read& read) {
  std::vector<Row> all;
  for (std::uint64_t part = 0; part < parts; ++part)
    for (const Row& row : read(table, table.bytes() * part / parts, table.bytes() * (part + 1) / parts))
      all.push_back(row);
  return all;
}

TEST(NetworkRows, PartsTogetherAreTheWhole) {
  const test::TemporaryFolder folder;
  std::string why_not;
  for (const auto& [end, last_end] :
       {std::pair{"\n", true}, {"\r\n", true}, {"\n", false}, {"\r\n", false}}) {
    const std::string nodes_file = folder.write("nodes.csv", table_of_nodes(60, end, last_end));
    const std::string edges_file = folder.write("edges.txt", table_of_edges(60, end, last_end));
    const Graph whole = read_graph(nodes_file, edges_file);
    ASSERT_EQ(whole.nodes(), 60u);
    const auto nodes = open_rows(nodes_file, node_columns(), why_not);
    const auto edges = open_rows(edges_file, edge_columns(), why_not);
    ASSERT_TRUE(nodes && edges) << why_not;
    for (const std::uint64_t parts : {1, 2, 3, 7, 50, 500, 5000}) {
      const auto rows = together<NodeRow>(*nodes, parts, nodes_of_part);
      ASSERT_EQ(rows.size(), whole.nodes()) << parts;
      for (std::size_t k = 0; k < rows.size(); ++k) {
        EXPECT_EQ(rows[k].id, whole.id[k]);
        EXPECT_EQ(rows[k].capacity, whole.capacity[k]);
        EXPECT_EQ(rows[k].source, whole.source[k]);
        EXPECT_EQ(rows[k].initial, whole.initial[k]);
        EXPECT_EQ(rows[k].fixed.has_value(), whole.is_fixed[k] != 0);
        EXPECT_EQ(rows[k].fixed.value_or(0), whole.fixed_value[k]);
      }
      const auto pairs = together<EdgeRow>(*edges, parts, edges_of_part);
      ASSERT_EQ(pairs.size(), whole.edges()) << parts;
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        EXPECT_EQ(pairs[k].i, 1000 - 3 * whole.i[k]);
        EXPECT_EQ(pairs[k].j, 1000 - 3 * whole.j[k]);
        EXPECT_EQ(pairs[k].conductance, whole.conductance[k]);
      }
    }
  }
}

TEST(NetworkRows, WhatTheFirstLinesDoNotSayIsNotReadInParts) {
  const test::TemporaryFolder folder;
  for (const auto& [text, reason] : {std::pair{"1 2 3\n2 3 3\n", "names"},
                                     {"# i j conductance\n1 2 3\n", "names"},
                                     {"i,j,conductance\n", "rows"},
                                     {"\xef\xbb\xbfi,j,conductance\n1,2,3\n", "mark"},
                                     {"\x1f\x8b and so on\n", "packed"}}) {
    std::string why_not;
    EXPECT_FALSE(open_rows(folder.write("edges.csv", text), edge_columns(), why_not)) << text;
    EXPECT_NE(why_not.find(reason), std::string::npos) << why_not;
  }
  std::string why_not;
  EXPECT_THROW((void)open_rows(folder.write("edges.csv", "i,j,k\n1,2,3\n"), edge_columns(), why_not),
               InputError);
  EXPECT_THROW((void)open_rows(folder.write("none", "") + "s", edge_columns(), why_not), InputError);
}

TEST(NetworkRows, APartThatIsWrongIsRefused) {
  const test::TemporaryFolder folder;
  std::string why_not;
  const std::string good = "i,j,conductance\n1,2,3\n2,3,4\n";
  for (const char* wrong : {"3,3,1\n", "3,4,-1\n", "3,4\n", "3,x,1\n", "3,4,nan\n", "3,4,1,\"\n"}) {
    const auto table = open_rows(folder.write("edges.csv", good + wrong), edge_columns(), why_not);
    ASSERT_TRUE(table);
    EXPECT_EQ(edges_of_part(*table, 0, 5).size(), 1u);
    EXPECT_THROW((void)edges_of_part(*table, 0, table->bytes()), InputError) << wrong;
  }
  const std::string long_comment = "# " + std::string(1 << 20, 'x') + "\n";  // longer than any head
  const auto table = open_rows(folder.write("edges.csv", good + long_comment + std::string("3,\0\n", 4)),
                               edge_columns(), why_not);
  ASSERT_TRUE(table);
  EXPECT_THROW((void)edges_of_part(*table, 0, table->bytes()), InputError) << "NUL bytes";
}

}  // namespace
}  // namespace superstep
