/// What programs write beside plain rows: several dumps in a file, names in comments, frames without
/// particles, ends that are cut off.

#include <gtest/gtest.h>

#include "support/packing_text.hpp"

namespace superstep {
namespace {

using test::expect_says;
using test::read_as;
using test::refusal;
using test::warns;

std::string dump_frame(const std::string& before, const std::string& rows) {
  return before +
         "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n-400 400\n-400 400\n-400 "
         "400\n"
         "ITEM: ATOMS id x y z radius\n" +
         rows;
}

TEST(ConcatenatedDumps, EachHasUnitsOfItsOwn) {
  const std::string rows = "1 0 0 0 55\n2 0 0 100 55\n", si = dump_frame("ITEM: UNITS\nsi\n", rows),
                    cgs = dump_frame("ITEM: UNITS\ncgs\n", rows), silent = dump_frame("", rows);
  const auto packing = read_as("a.dump", si + cgs);
  EXPECT_DOUBLE_EQ(packing.radius[0], 0.55);
  EXPECT_TRUE(test::notes(packing, "units cgs, as line 15 says"));
  EXPECT_DOUBLE_EQ(read_as("a.dump", si + cgs + silent).radius[0], 0.55) << "a program states them once";
  EXPECT_DOUBLE_EQ(read_as("a.dump", cgs + si + silent).radius[0], 55);
}

TEST(YadeText, AttributesAreNamedByACommentOfAllColumns) {
  const std::string rows = "0\t0\t0\t0.55\t300\t1\n0\t0\t1\t0.55\t310\t2\n";
  for (const char* comment : {"# x y z r T q\n", "#T q\n"}) {
    const auto packing = read_as("a.txt", std::string("#format x_y_z_r_attrs\n") + comment + rows);
    ASSERT_NE(find_attribute(packing, "T"), nullptr) << comment;
    EXPECT_EQ(find_attribute(packing, "T")->value, (std::vector<double>{300, 310}));
    EXPECT_EQ(find_attribute(packing, "q")->value, (std::vector<double>{1, 2}));
  }
  EXPECT_NE(
      find_attribute(read_as("a.txt", "#format x_y_z_r_attrs\n# made on a Monday in May\n" + rows), "attr1"),
      nullptr);
}

TEST(MercuryText, DiscsAfterFramesWithoutAny) {
  const std::string frame = "3 0.2 -1 -1 3 3\n0 0 0 0 0.55 0 0 0\n0 1 0 0 0.55 0 0 0\n0 2 0 0 0.55 0 0 1\n";
  for (const char* empty : {"0 0.1 -1 -1 3 3\n", "0 0.1 -1 -1 3 3\n0 0.15 -1 -1 3 3\n"}) {
    const auto packing = read_as("a.data", empty + frame);
    EXPECT_EQ(packing.format, "MercuryDPM .data");
    ASSERT_EQ(packing.size(), 3u);
    EXPECT_EQ(packing.centre[2].y, 2);
  }
  expect_says(refusal("0 0.1 0.2 0.3 0.4 0.5\n1 0.1 0.2 0.3 0.4 0.5\n"), {"rows of 6 columns"});
}

TEST(Ends, ALastNumberWithoutAnEndIsSaid) {
  const std::string whole = dump_frame("", "1 0 0 0 0.55\n2 0 0 1 0.55");
  EXPECT_FALSE(warns(read_as("a.dump", whole + "\n"), "no end"));
  EXPECT_TRUE(warns(read_as("a.dump", whole.substr(0, whole.size() - 1)), "its last line has no end"));
  const std::string data =
      "t\n\n1 atoms\n1 atom types\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nAtoms # sphere\n\n1 1 0.5 2.5 3 "
      "4 1.5";
  EXPECT_TRUE(warns(read_as("a.data", data), "no end"));
  EXPECT_TRUE(warns(read_as("a.xyz", "1\nProperties=pos:R:3:radius:R:1\n0 0 1 0.5"), "no end"));
  EXPECT_TRUE(warns(read_as("a.vtk",
                            "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\n"
                            "POINT_DATA 1\nSCALARS radius float\nLOOKUP_TABLE default\n0.5"),
                    "no end"));
  EXPECT_TRUE(read_as("a.csv", "x,y,z,r\n0,0,0,0.5").warnings.empty()) << "tables are written by hand, too";
}

}  // namespace
}  // namespace superstep
