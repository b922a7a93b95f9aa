/// The comment line of extended XYZ: Lattice and pbc in every legal form, and what is none.

#include <gtest/gtest.h>

#include "support/packing_text.hpp"

namespace superstep {
namespace {

using test::expect_says;
using test::read_as;
using test::refusal;

std::string frame_of(const std::string& comment) {
  return "3\n" + comment + " Properties=pos:R:3:radius:R:1\n0 0 0.5 0.55\n0 0 1.5 0.55\n0 0 2.5 0.55\n";
}

TEST(XyzComment, WordsOfPbcAreUnderstoodOrRefused) {
  const std::string lattice = "Lattice=\"4 0 0 0 4 0 0 0 3\" ";
  for (const char* words : {"F F T", "False False True", "false false true", "FALSE FALSE TRUE", "0 0 1"})
    EXPECT_EQ(read_as("a.xyz", frame_of(lattice + "pbc=\"" + words + "\"")).cell->periodic_axes(), "z")
        << words;
  for (const char* words : {"p p p", "f f t", "F F yes", "2 0 1"})
    expect_says(refusal(frame_of(lattice + "pbc=\"" + words + "\"")), {"p.txt:2:", "pbc holds", "T or F"});
  expect_says(refusal(frame_of("pbc=\"F F T\"")), {"p.txt:2:", "no Lattice"});
  EXPECT_FALSE(read_as("a.xyz", frame_of("pbc=\"F F F\"")).cell.has_value());
}

TEST(XyzComment, LatticesInEveryLegalForm) {
  for (const char* comment :
       {"Lattice = \"4 0 0 0 4 0 0 0 3\" pbc = \"F F T\"", "Lattice=[[4,0,0],[0,4,0],[0,0,3]] pbc=[F,F,T]",
        "Lattice=[4, 0, 0, 0, 4, 0, 0, 0, 3] pbc=[false, false, true]",
        "Lattice={4 0 0 0 4 0 0 0 3} pbc={F F T}",
        "flag Lattice='4 0 0 0 4 0 0 0 3' title=\"a = \\\"pbc=\\\"\" pbc=\"F F T\"",
        "Lattice= [ [ 4, 0, 0 ], [ 0, 4, 0 ], [ 0, 0, 3 ] ] pbc = [ F, F, T ]"}) {
    const auto packing = read_as("a.xyz", frame_of(comment));
    ASSERT_TRUE(packing.cell.has_value()) << comment;
    EXPECT_EQ(packing.cell->edge[2].z, 3) << comment;
    EXPECT_EQ(packing.cell->periodic_axes(), "z") << comment;
  }
  expect_says(refusal(frame_of("Lattice=[[4,1,0],[0,4,0],[0,0,3]]")), {"p.txt:2:", "matrix in brackets"});
  EXPECT_EQ(
      read_as("a.xyz", "1\nLattice = \"4 0 0 0 4 0 0 0 3\" Properties = pos:R:3:radius:R:1\n0 0 1 0.5\n")
          .size(),
      1u);
}

}  // namespace
}  // namespace superstep
