/// Tables of particles as spreadsheets, NumPy, pandas and ParaView write them.

#include <gtest/gtest.h>

#include <cmath>

#include "support/packing_text.hpp"

namespace superstep {
namespace {

using Ids = std::vector<std::int64_t>;
using Names = std::vector<std::string>;

using test::expect_says;
using test::notes;
using test::read_as;
using test::refusal;
using test::warns;

/// The column of four spheres that most files here hold: z = 0.01, 0.03, 0.05, 0.07, radius 0.0102.
void expect_column(const Packing& packing, const Ids& ids = {1, 2, 3, 4}) {
  ASSERT_EQ(packing.size(), 4u);
  EXPECT_EQ(packing.id, ids);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(packing.centre[k].x, 0.05, 1e-12);
    EXPECT_NEAR(packing.centre[k].z, 0.01 + 0.02 * static_cast<double>(k), 1e-12);
    EXPECT_NEAR(packing.radius[k], 0.0102, 1e-12);
  }
}

/// Rows "K HEAD z TAIL" of the column.
std::string column_rows(const std::string& before, const std::string& after, double scale = 1,
                        bool ids = true, const std::string& separator = " ") {
  std::string out;
  for (int k = 1; k <= 4; ++k) {
    if (ids) out += std::to_string(k) + separator;
    out += before + separator + std::to_string(scale * (0.02 * k - 0.01));
    if (!after.empty()) out += separator + after;
    out += "\n";
  }
  return out;
}

TEST(Tables, AsSpreadsheetsNumpyAndParaViewWriteThem) {
  const std::string plain = column_rows("0.05,0.05", "0.0102", 1, true, ",");
  expect_column(read_as("a.csv", "\"id\",\"x\",\"y\",\"z\",\"radius\"\n" + plain));
  expect_column(read_as("a.csv", "ID,X,Y,Z,R\n" + plain));
  expect_column(read_as("a.csv", "# id,x,y,z,radius\n" + plain));
  expect_column(read_as("a.csv", plain));
  expect_column(read_as("a.csv", "id;x;y;z;d\n" + column_rows("0.05;0.05", "0.0204", 1, true, ";")));
  expect_column(
      read_as("a.csv", "sep=;\nid;x;y;z;diameter\n" + column_rows("0.05;0.05", "0.0204", 1, true, ";")));
  expect_column(
      read_as("a.tsv", "id\tx\ty\tz\tradius\n" + column_rows("0.05\t0.05", "0.0102", 1, true, "\t")));
  expect_column(read_as("a.csv", "particle id,pos_x,pos_y,pos_z,radius\n" + plain));
  expect_column(read_as(
      "a.csv", ",id,x,y,z,radius\n0," + plain.substr(0, plain.find('\n') + 1) +
                   "1,2,0.05,0.05,0.03,0.0102\n2,3,0.05,0.05,0.05,0.0102\n3,4,0.05,0.05,0.07,0.0102\n"));
  std::string paraview = "\"radius\",\"Points:0\",\"Points:1\",\"Points:2\",\"Velocity:0\"\n";
  for (const char* z : {"0.01", "0.03", "0.05", "0.07"})
    paraview += std::string("0.0102,0.05,0.05,") + z + ",1\n";
  expect_column(read_as("a.csv", paraview), {0, 1, 2, 3});
  expect_column(read_as("a.txt", "# made by hand\n" + column_rows("0.05 0.05", "0.0102", 1, false)),
                {0, 1, 2, 3});
  expect_column(read_as("a.txt", "x y  z r\n" + column_rows("0.05 \t0.05", "0.0102", 1, false)),
                {0, 1, 2, 3});
}

TEST(Tables, FurtherColumnsAreAttributesAndTextIsLeftOut) {
  const auto packing =
      read_as("a.csv", "id,x,y,z,r,temperature,colour,gap\n1,0,0,0,1,300.5,red,\n2,3,0,0,1,301.5,blue,nan\n");
  ASSERT_EQ(packing.attributes.size(), 2u);
  EXPECT_EQ(packing.attributes[0].value, (std::vector<double>{300.5, 301.5}));
  EXPECT_TRUE(std::isnan(packing.attributes[1].value[0]));
  EXPECT_TRUE(notes(packing, "hold text: colour"));
  EXPECT_EQ(read_as("a.csv", "id,x,y,z,r,matrial\n1,0,0,0,1,1\n").warnings.size(), 1u);
}

TEST(Tables, UnitsStandBehindNames) {
  const auto packing = read_as("a.csv", "id,x (mm),y [mm],z_mm,radius [um]\n1,1,2,3,50\n");
  EXPECT_DOUBLE_EQ(packing.centre[0].z, 3e-3);
  EXPECT_NEAR(packing.radius[0], 50e-6, 1e-18);
  expect_says(refusal("x (mm),y,z,radius\n1,2,3,4\n"), {"units for some"});
  PackingOptions metres;
  metres.length_unit = 1;
  expect_says(refusal("x (mm),y (mm),z (mm),radius (mm)\n1,2,3,4\n", metres), {"mm, as the names"});
}

TEST(Tables, SixteenBitTextAndOldLineEnds) {
  const std::string text = "id,x,y,z,radius\r\n" + column_rows("0.05,0.05", "0.0102", 1, true, ",");
  for (const bool little : {true, false})
    for (const bool marked : {true, false}) {
      std::string wide;
      if (marked) wide = little ? "\xFF\xFE" : "\xFE\xFF";
      for (const char c : text) wide += little ? std::string{c, '\0'} : std::string{'\0', c};
      expect_column(read_as("a.csv", wide));
    }
  const std::string micro = "x [\xB5m],y [\xB5m],z [\xB5m],r [\xB5m]\n1,2,3,4\n";
  std::string wide;
  for (const char c : micro) wide += {c, '\0'};
  EXPECT_NEAR(read_as("a.csv", wide).radius[0], 4e-6, 1e-18);
  std::string old = "id,x,y,z,radius\n" + column_rows("0.05,0.05", "0.0102", 1, true, ",");
  for (auto& c : old)
    if (c == '\n') c = '\r';
  expect_column(read_as("a.csv", old));
}

TEST(Tables, WhatCannotBeKnownIsAsked) {
  expect_says(refusal("0.1,0.2,0.3,0.4,7\n0.5,0.2,0.3,0.4,8\n"),
              {"p.txt:1:", "without a header", "columns = ["});
  expect_says(refusal("0 0 0\n1 0 0\n"), {"rows of 3 columns"});
  expect_says(refusal("id;x;y;z;radius\n1;0,05;0,05;0,010;0,0102\n"),
              {"p.txt:2:", "'x' is '0,05'", "decimal"});
  expect_says(refusal("id\tx\ty\tz\tr\n1 0 0 0 1\n"), {"p.txt:2:", "1 cells between tabs", "divided alike"});
  expect_says(refusal("0,05\t0,05\t0,010\t0,0102\n"), {"p.txt:1:", "'0,05'", "decimal"});
  expect_says(refusal("id,x,y,z,radius\n1,0,0,0,\"1\n"), {"p.txt:2:", "quote"});
  expect_says(refusal("id,x,y,z,r,diameter\n1,0,0,0,1,1\n"), {"radius is 1 and diameter 1"});
  PackingOptions declared;
  declared.columns = {"x", "y", "z", "radius", "material"};
  EXPECT_EQ(read_as("a.csv", "0.1,0.2,0.3,0.4,steel\n5,0.2,0.3,0.4,glass\n", declared).material_names,
            (Names{"steel", "glass"}));
  declared.columns.pop_back();
  expect_says(refusal("0.1,0.2,0.3,0.4,7\n", declared), {"5 columns, and 4 are declared"});
}

TEST(Tables, TheDelimiterThatASpreadsheetStatesMayBeATab) {
  expect_column(
      read_as("a.tsv", "sep=\t\r\nid\tx\ty\tz\tr\r\n" + column_rows("0.05\t0.05", "0.0102", 1, true, "\t")));
}

/// The sign of comments is also what people call a column of numbers.
TEST(Tables, AHeaderThatBeginsWithANumberSignIsOne) {
  for (const char sign : {',', ';', '\t'}) {
    std::string text = "#,x,y,z,d\n" + column_rows("0.05,0.05", "0.0204", 1, true, ",");
    for (auto& c : text) c = c == ',' ? sign : c;
    expect_column(read_as("a.csv", text));
  }
  expect_column(read_as("a.csv", "\"#\",x,y,z,d\n" + column_rows("0.05,0.05", "0.0204", 1, true, ",")));
  const auto packing = read_as("a.csv", "#,id,x,y,z,r\n1,7,0,0,0,1\n2,9,0,0,3,1\n");
  EXPECT_EQ(packing.id, (Ids{7, 9}));
  EXPECT_EQ(read_as("a.csv", "#, made by hand\n0,0,0,1\n").size(), 1u);
}

TEST(Tables, AHeaderInAnotherLanguageIsNotTakenForProse) {
  for (const char* head : {"# Nr X Y Z Durchmesser\n", "#Nr;X;Y;Z;Durchmesser\n", "% n, x, y, z, diametre\n"})
    expect_says(refusal(head + column_rows("0.05 0.05", "0.0204")),
                {"p.txt:1:", "none of them radius or diameter", "columns = ["});
  PackingOptions declared;
  declared.columns = {"id", "x", "y", "z", "diameter"};
  expect_column(read_as("a.txt", "# Nr X Y Z Durchmesser\n" + column_rows("0.05 0.05", "0.0204"), declared));
  EXPECT_EQ(read_as("a.txt", "# spheres of a steel box\n1 0 0 0 1\n2 0 0 0.5 1.5\n").size(), 2u);
}

/// np.savetxt writes its header above every block that goes into an open file.
TEST(Tables, AHeaderThatStandsAgainBeginsAnotherTable) {
  const std::string block = "# x y z r\n0 0 0 1\n0 0 3 1\n";
  expect_says(refusal(block + "# x y z r\n0 0 0.5 1\n0 0 3.5 1\n"), {"p.txt:4:", "of line 1 stands again"});
  EXPECT_EQ(read_as("a.txt", block + "# the rest\n0 0 6 1\n").size(), 3u);
}

/// Rows with words below names in a comment: no number tells that they are one.
TEST(Tables, WordsBetweenBlanksBelowAHeaderInAComment) {
  for (const char* head :
       {"# id x y z r material\n", "% ID X Y Z R Mat\n", "# id x [m] y [m] z [m] r [m] material\n"})
    expect_column(read_as("a.txt", head + column_rows("0.05 0.05", "0.0102 steel")));
}

/// Metres are taken where no unit is stated in a way that is read, which must not pass in silence.
TEST(Tables, AUnitThatACommentMentionsIsSaid) {
  for (const char* head : {"# x y z r\n# mm mm mm mm\n", "# lengths in um\nx y z r\n",
                           "% [nm]\n\n# x y z r\n", "# Unit: \xC2\xB5m\nx y z r\n"})
    EXPECT_TRUE(warns(read_as("a.txt", head + std::string("0 0 0 1\n")), "a comment mentions")) << head;
  PackingOptions millimetres;
  millimetres.length_unit = 1e-3;
  EXPECT_TRUE(read_as("a.txt", "# all in mm\n0 0 0 1\n", millimetres).warnings.empty());
  for (const char* head : {"# length_unit = \"mm\"\n", "# x [mm] y [mm] z [mm] r [mm]\n",
                           "# x y z r\n# m m m m\n", "# made of NM-5 at 3 cm2\n"})
    EXPECT_TRUE(read_as("a.txt", head + std::string("0 0 0 1\n")).warnings.empty()) << head;
}

/// Loops that write a delimiter behind every cell do so behind the last one, too, and not always in the
/// header.
TEST(Tables, ADelimiterAtTheEndOfRowsOrOfTheHeaderIsNoCell) {
  const std::string rows = column_rows("0.05,0.05", "0.0102", 1, true, ","),
                    ended = column_rows("0.05, 0.05", "0.0102, ", 1, true, ", ");
  expect_column(read_as("a.csv", "id,x,y,z,r\n" + ended));
  expect_column(read_as("a.csv", "id,x,y,z,r,\n" + rows));
  expect_column(read_as("a.csv", "id,x,y,z,r,\n" + ended));
  expect_column(read_as("a.csv", "# id, x, y, z, r\n" + ended));
  expect_column(read_as("a.csv", "id;x;y;z;r\n" + column_rows("0.05;0.05", "0.0102;", 1, true, ";")));
  expect_says(refusal("id,x,y,z,r,T\n1,0,5,0,0,1,\n"), {"p.txt:2:", "7 cells", "a decimal point"});
  expect_says(refusal("id,x,y,z,r\n1,0,0,0,1,5\n"), {"p.txt:2:", "6 cells"});
  expect_says(refusal("id,x,y,z,r\n1,0,0,0\n"), {"p.txt:2:", "4 cells"});
}

/// A row that begins with an error of a spreadsheet would be a comment, and its particle gone.
TEST(Tables, ErrorsOfSpreadsheetsAreCells) {
  for (const char* error : {"#N/A", "#DIV/0!", "#NAME?", "#WERT!", "#NV"}) {
    EXPECT_EQ(read_as("a.csv", "T,x,y,z,r\n300,0,0,0,1\n" + std::string(error) + ",0,0,3,1\n").size(), 2u)
        << error;
    expect_says(refusal("x;y;z;r\n0;0;0;1\n" + std::string(error) + ";0;3;1\n"),
                {"p.txt:3:", "'x' is", error});
  }
  for (const char* comment : {"#NOTE: a row", "#0,0,9,1", "#NEW! a packing", "#N"})
    EXPECT_EQ(read_as("a.csv", "x,y,z,r\n0,0,0,1\n" + std::string(comment) + "\n0,0,3,1\n").size(), 2u)
        << comment;
}

TEST(Tables, TheNameOfAFileSaysWhetherItsTextHoldsDiameters) {
  EXPECT_EQ(read_as("a.xyzd", "0 0 0 1\n0 0 3 1\n").radius[0], 0.5);
  EXPECT_EQ(read_as("a.xyzr", "0 0 0 1\n0 0 3 1\n").radius[0], 1);
  EXPECT_EQ(read_as("b.xyzd", "x y z r\n0 0 0 1\n").radius[0], 1);
}

}  // namespace
}  // namespace superstep
