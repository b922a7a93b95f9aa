/// Packing files as codes write them: each kind in a few of its dialects.

#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <cmath>
#include <cstring>

#include "support/packing_text.hpp"

namespace superstep {
namespace {

using Ids = std::vector<std::int64_t>;
using Names = std::vector<std::string>;

using test::expect_says;
using test::notes;
using test::read_as;
using test::refusal;

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

std::string dump(const std::string& columns, const std::string& rows, const std::string& box = "ff ff ff",
                 const std::string& before = "") {
  return before + "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n4\nITEM: BOX BOUNDS " + box +
         "\n0 0.1\n0 0.1\n0 0.08\nITEM: ATOMS " + columns + "\n" + rows;
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

std::string gzipped(const std::string& text) {
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, text.size()) + 100, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

TEST(LammpsDumpDialects, CapitalsScaledUnwrappedAndFloatIds) {
  expect_column(read_as("a.dump", dump("id type x y z Radius", column_rows("1 0.05 0.05", "0.0102"))));
  expect_column(read_as("a.dump", dump("id type xs ys zs radius", column_rows("1 0.5 0.5", "0.0102", 12.5))));
  expect_column(read_as("a.dump", dump("id type xu yu zu diameter", column_rows("1 0.05 0.05", "0.0204"))));
  expect_column(
      read_as("a.dump", dump("ID TYPE xsu ysu zsu Diameter", column_rows("1 0.5 0.5", "0.0204", 12.5))));
  std::string rows;
  for (const char* row : {"1.0 1 0.05 0.05 0.01 0.0102\n", "2e0 1 0.05 0.05 0.03 0.0102\n",
                          "3.000000e+00 1 0.05 0.05 0.05 0.0102\n", "4 1.0 0.05 0.05 0.07 0.0102\n"})
    rows += row;
  const auto packing = read_as("a.dump", dump("id type x y z radius", rows));
  expect_column(packing);
  EXPECT_TRUE(packing.material_names.empty()) << "1.0 and 1 are one type";
}

TEST(LammpsDumpDialects, ColumnsOfFixesAndComputesAreAttributes) {
  const auto packing = read_as("a.dump", dump("id type x y z ix vx c_peratom[2] radius f_Temp[0]",
                                              column_rows("1 0.05 0.05", "0 0.5 9 0.0102 301")));
  expect_column(packing);
  ASSERT_EQ(packing.attributes.size(), 4u);
  ASSERT_NE(find_attribute(packing, "F_Temp[0]"), nullptr);
  EXPECT_EQ(find_attribute(packing, "f_Temp[0]")->value, (std::vector<double>{301, 301, 301, 301}));
  EXPECT_TRUE(notes(packing, "vx"));
}

TEST(LammpsDumpDialects, UnitsAreObeyedAndNotContradicted) {
  const std::string content =
      dump("id type x y z radius", column_rows("1 0.05 0.05", "0.0102"), "ff ff ff", "ITEM: UNITS\ncgs\n");
  const auto packing = read_as("a.dump", content);
  EXPECT_DOUBLE_EQ(packing.radius[0], 0.0102e-2);
  EXPECT_EQ(packing.length_unit, 1e-2);
  PackingOptions mm;
  mm.length_unit = 1e-3;
  expect_says(refusal(content, mm), {"mm", "units cgs, as line 2 says"});
  PackingOptions micro;
  micro.units = "micro";
  EXPECT_DOUBLE_EQ(
      read_as("a.dump", dump("id type x y z radius", column_rows("1 0.05 0.05", "0.0102")), micro).radius[0],
      0.0102e-6);
  const auto lj = read_as("a.dump", dump("id type x y z radius", column_rows("1 0.05 0.05", "0.0102"),
                                         "ff ff ff", "ITEM: UNITS\nlj\n"));
  EXPECT_EQ(lj.warnings.size(), 1u) << "a length without dimension is no length";
  expect_says(refusal("ITEM: UNITS\ninches\n" + dump("x y z radius", "")), {"p.txt:2:", "inches"});
}

TEST(LammpsDumpDialects, BoxesAreKeptTiltedOnesToo) {
  const auto periodic =
      read_as("a.dump", dump("id type x y z radius", column_rows("1 0.05 0.05", "0.0102"), "pp pp pp"));
  ASSERT_TRUE(periodic.cell.has_value());
  EXPECT_EQ(periodic.cell->periodic_axes(), "xyz");
  EXPECT_NEAR(periodic.cell->volume(), 8e-4, 1e-12);
  const auto mixed =
      read_as("a.dump", dump("id type x y z radius", column_rows("1 0.05 0.05", "0.0102"), "pp fs mm"));
  EXPECT_EQ(mixed.cell->periodic_axes(), "x");
  // Bounds of a box of 2 x 3 x 4 with tilts 1, 0.5 and -0.25: they enclose it.
  const auto tilted =
      read_as("a.dump",
              "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS xy xz yz pp pp pp\n"
              "0 3.5 1\n-0.25 3 0.5\n0 4 -0.25\nITEM: ATOMS xs ys zs radius\n0.5 0.5 0.5 0.1\n");
  EXPECT_NEAR(tilted.cell->volume(), 24, 1e-12);
  EXPECT_NEAR(tilted.centre[0].x, 1 + 0.5 + 0.25, 1e-12);
  EXPECT_NEAR(tilted.centre[0].y, 1.5 - 0.125, 1e-12);
  expect_says(
      refusal("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS xs ys zs radius\n0.5 0.5 0.5 0.1\n"),
      {"parts of a box"});
}

TEST(LammpsDumpDialects, CentresFarOutsideTheBoxAreReadFromWrongColumns) {
  expect_says(refusal(dump("id type x y z radius", column_rows("1 0.05 2500", "0.0102"))),
              {"p.txt:10:", "2500", "far outside the box", "columns = ["});
  EXPECT_NO_THROW((void)read_as(
      "a.dump", dump("id type xu yu zu radius", column_rows("1 0.05 2500", "0.0102"), "pp pp pp")))
      << "unwrapped positions leave a periodic box";
}

TEST(Packed, GzippedFilesOfEveryTextFormat) {
  const std::string text = dump("id type x y z radius", column_rows("1 0.05 0.05", "0.0102"));
  expect_column(read_as("a.dump.gz", gzipped(text)));
  expect_column(read_as("misleading.csv",
                        gzipped("id,x,y,z,radius\n" + column_rows("0.05,0.05", "0.0102", 1, true, ","))));
  const std::string packed = gzipped(text);
  expect_column(read_as(
      "two.gz", gzipped(text.substr(0, 50)) + gzipped(text.substr(50))));  // members follow each other
  expect_says(refusal(packed.substr(0, packed.size() / 2)), {"cut off"});
  std::string damaged = packed;
  damaged[packed.size() / 2] = static_cast<char>(damaged[packed.size() / 2] ^ 0x55);
  EXPECT_NE(refusal(damaged), "");
  expect_column(read_as("padded.gz", packed + std::string(512, '\0')));
  expect_says(refusal(packed + "5 1 0.05 0.05 0.09 0.0102\n"), {"goes on behind its last packed part"});
}

std::string data(const std::string& heading, const std::string& rows, const std::string& title = "title") {
  return title + "\n\n4 atoms\n1 atom types\n\n0 0.1 xlo xhi\n0 0.1 ylo yhi\n0 0.08 zlo zhi\n\n" + heading +
         "\n\n" + rows;
}

TEST(LammpsDataDialects, TheOnlyOrderOfColumnsThatMakesSenseIsTaken) {
  for (const char* heading : {"Atoms", "Atoms # hybrid", "Atoms # hybrid sphere"}) {
    const auto packing = read_as("a.data", data(heading, column_rows("1 0.05 0.05", "0.0204 2500")));
    expect_column(packing);
    EXPECT_TRUE(notes(packing, "hybrid sphere"));
  }
  expect_column(read_as("a.data", data("Atoms", column_rows("1 0.0204 2500 0.05 0.05", ""))));
  expect_column(read_as("a.data", data("Atoms # bpm/sphere", column_rows("7 1 0.0204 2500 0.05 0.05", ""))));
  expect_column(read_as(
      "a.data", data("Atoms # hybrid bond sphere", column_rows("1 0.05 0.05", "7 0.0204 2500 0 0 -1"))));
}

TEST(LammpsDataDialects, AmbiguousOrWrongOrdersSayWhatToDeclare) {
  // In a wide box a density may be a coordinate.
  const std::string wide =
      "t\n\n1 atoms\n1 atom types\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nAtoms\n\n1 1 0.5 2.5 3 4 1.5\n";
  expect_says(refusal(wide), {"p.txt:11:", "more than one order", "atom_style = \"sphere\"",
                              "atom_style = \"hybrid sphere\""});
  PackingOptions sphere, columns;
  sphere.atom_style = "sphere";
  EXPECT_EQ(read_as("a.data", wide, sphere).radius[0], 0.25);
  columns.columns = {"id", "type", "x", "y", "z", "diameter", "density"};
  EXPECT_EQ(read_as("a.data", wide, columns).radius[0], 2.0);
  expect_says(refusal(data("Atoms # sphere", column_rows("1 0.05 0.05", "0.0204 2500"))),
              {"far outside the box", "declare"});
  expect_says(refusal(data("Atoms # full", column_rows("1 1 0.0", "0.05 0.05"))), {"'full'", "hybrid"});
  expect_says(refusal(data("Atoms", column_rows("1 7 8 9", "0.05 0.05 0.0204"))), {"no order of columns"});
  // Ellipsoids have a flag and a density there.
  const std::string ellipsoids = data("Atoms", column_rows("1 1 2500 0.05 0.05", "")) + "\nEllipsoids\n\n";
  expect_says(refusal(ellipsoids), {"'Ellipsoids'", "atom_style"});
  PackingOptions unknown;
  unknown.atom_style = "hybrid sphere spin";
  expect_says(refusal(wide, unknown), {"'spin'", "columns"});
}

TEST(LammpsDataDialects, UnitsInTheTitleAndBoxesWithAndWithoutTilt) {
  const auto packing = read_as(
      "a.data", data("Atoms # sphere", column_rows("1 0.0204 2500 0.05 0.05", ""),
                     "LAMMPS data file via write_data, version 2 Aug 2023, timestep = 0, units = cgs"));
  EXPECT_DOUBLE_EQ(packing.radius[0], 0.0102e-2);
  EXPECT_FALSE(packing.cell->is_periodic()) << "a data file does not say so";
  PackingOptions periodic;
  periodic.periodic = "zx";
  EXPECT_EQ(read_as("a.data", data("Atoms # sphere", column_rows("1 0.0204 2500 0.05 0.05", "")), periodic)
                .cell->periodic_axes(),
            "xz");
}

TEST(YadeDialects, ClumpsAttributesAndIds) {
  const auto clumps = read_as("a.txt", "#format x_y_z_r_clumpId\n0 0 0 1 -1\n1.5 0 0 1 3\n");
  ASSERT_NE(find_attribute(clumps, "clumpId"), nullptr);
  EXPECT_EQ(find_attribute(clumps, "clumpId")->value[1], 3);
  const auto attributes = read_as("a.txt", "#format x_y_z_r_attrs\n#dstN dstV_x\n0 0 0 1 5 6\n3 0 0 1 7 8\n");
  ASSERT_NE(find_attribute(attributes, "dstV_x"), nullptr);
  EXPECT_EQ(find_attribute(attributes, "dstV_x")->value, (std::vector<double>{6, 8}));
  EXPECT_NE(find_attribute(read_as("a.txt", "#format x_y_z_r_attrs\n0 0 0 1 5\n"), "attr1"), nullptr);
  const auto ids = read_as("a.txt", "#format id_x_y_z_r_matId\n7 0 0 0 1 0\n9 3 0 0 1 2\n");
  EXPECT_EQ(ids.id, (Ids{7, 9}));
  EXPECT_EQ(ids.material_names, (Names{"0", "2"}));
  expect_says(refusal("#format x_y_z\n0 0 0\n"), {"p.txt:1:", "x_y_z_r"});
}

TEST(XyzDialects, ExtendedOnesHaveRadiiCellsAndFrames) {
  const std::string rows =
      "Si 0.05 0.05 0.01 0.0102\nSi 0.05 0.05 0.03 0.0102\nC 0.05 0.05 0.05 0.0102\nSi 0.05 0.05 0.07 "
      "0.0102\n";
  const std::string head =
      "4\nLattice=\"0.1 0 0 0 0.1 0 0 0 0.08\" Properties=species:S:1:pos:R:3:radius:R:1 pbc=\"T T F\"\n";
  const auto packing = read_as("a.xyz", head + rows + head + rows);
  expect_column(packing, {0, 1, 2, 3});
  EXPECT_EQ(packing.cell->periodic_axes(), "xy");
  EXPECT_EQ(packing.material_names, (Names{"Si", "C"}));
  EXPECT_EQ(packing.frame, "the last of 2 frames");
  const auto more = read_as("a.xyz", "1\nProperties=id:I:1:pos:R:3:velo:R:3:Radius:R:1\n5 1 2 3 7 8 9 0.5\n");
  EXPECT_EQ(more.id, Ids{5});
  EXPECT_EQ(find_attribute(more, "velo:1")->value[0], 8);
  expect_says(refusal("2\n\nA 0 0 0\nA 1 0 0\n"), {"p.txt:2:", "plain XYZ", "no radii"});
  expect_says(refusal("2\nProperties=species:S:1:pos:R:3\nA 0 0 0\nA 1 0 0\n"), {"'radius' is missing"});
  PackingOptions declared;
  declared.columns = {"type", "x", "y", "z", "radius"};
  EXPECT_EQ(read_as("a.xyz", "1\n\nA 0 0 0 2\n", declared).radius[0], 2);
}

TEST(MercuryDialects, TwoDimensionsAreDiscsInThePlane) {
  const auto packing = read_as("a.data", "2 0.5 0 0 1 1 \n1 2 0 0 0.25 0 0 0 \n3 4 0 0 0.5 0 0 1 \n");
  ASSERT_EQ(packing.size(), 2u);
  EXPECT_EQ(packing.centre[1].y, 4);
  EXPECT_EQ(packing.centre[1].z, 0);
  EXPECT_EQ(packing.radius[1], 0.5);
  EXPECT_TRUE(notes(packing, "two dimensions"));
}

TEST(Doubles, AreReadByTheirDeclaredNameOrThatOfTheFile) {
  const std::vector<double> rows = {0, 0, 0, 2, 3, 0, 0, 1};
  std::string bytes(rows.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), rows.data(), bytes.size());
  EXPECT_EQ(read_as("packing.xyzd", bytes).radius, (std::vector<double>{1, 0.5}));
  PackingOptions radii;
  radii.format = "xyzr";
  EXPECT_EQ(read_as("packing.bin", bytes, radii).radius, (std::vector<double>{2, 1}));
  expect_says(refusal(bytes), {"binary", "xyzd"});
  expect_says(refusal(bytes.substr(0, 50), radii), {"50 bytes", "four doubles"});
}

/// The bytes of a few random numbers may hold no NUL, begin like a text in another encoding, or hold what
/// ends the lines of old files.
TEST(Doubles, AreTakenByteByByte) {
  const std::array<std::string, 4> number = {
      std::string("\xFF\xFE\x5D\x21\x18\x0D\x48\x3F"), std::string("\x01\x0D\x13\xF3\x72\x9B\xDB\x3F"),
      std::string("\x3C\x30\x0F\x54\xC4\x7F\xE2\x3F"), std::string("\x0D\x2A\xBE\x7A\x41\x7C\x13\x40")};
  PackingOptions radii;
  radii.format = "xyzr";
  const auto expect_same_bits = [&](const std::array<std::size_t, 3>& at, const Packing& packing) {
    const auto value = [&](std::size_t k) {
      double out = 0;
      std::memcpy(&out, number[k].data(), sizeof out);
      return out;
    };
    EXPECT_EQ(packing.centre[0].x, value(at[0]));
    EXPECT_EQ(packing.centre[0].y, value(at[1]));
    EXPECT_EQ(packing.centre[0].z, value(at[2]));
    EXPECT_EQ(packing.radius[0], value(3));
  };
  expect_same_bits({0, 1, 2}, read_as("a.bin", number[0] + number[1] + number[2] + number[3], radii));
  expect_same_bits({1, 0, 2}, read_as("a.xyzr", number[1] + number[0] + number[2] + number[3]));
  EXPECT_EQ(read_as("text.xyzr", "0 0 0 1\n0 0 3 1\n").size(), 2u);
}

TEST(ReadPacking, BoxesAndPeriodicSidesOfTheUser) {
  PackingOptions options;
  options.periodic = "xyz";
  expect_says(refusal("x,y,z,radius\n0,0,0,1\n", options), {"states no box", "box = {"});
  options.box = box_cell({0, 0, 0}, {10, 10, 10});
  options.length_unit = 1e-3;
  const auto packing = read_as("a.csv", "x,y,z,radius\n-1,0,15,1\n", options);
  EXPECT_NEAR(packing.cell->volume(), 1e-6, 1e-15);
  EXPECT_NEAR(packing.centre[0].x, 9e-3, 1e-12) << "centres are moved into a periodic cell";
  EXPECT_NEAR(packing.centre[0].z, 5e-3, 1e-12);
  PackingOptions none;
  none.periodic = "none";
  const auto open =
      read_as("a.dump", dump("id type x y z radius", column_rows("1 0.05 0.05", "0.0102"), "pp pp pp"), none);
  EXPECT_FALSE(open.cell->is_periodic());
  EXPECT_EQ(open.warnings.size(), 1u);
  expect_says(refusal("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 "
                      "0\nITEM: ATOMS x y z radius\n0 0 0 1\n"),
              {"no volume", "periodic = \"none\""});
}

TEST(PackingCsv, ReadsBackCellAttributesAndAll) {
  Packing packing = read_as(
      "a.dump", dump("id type x y z radius f_Temp", column_rows("1 0.05 0.05", "0.0102 301.25"), "pp pp ff"));
  const auto again = read_as("a.csv", packing_csv(packing));
  expect_column(again);
  EXPECT_EQ(again.cell->periodic_axes(), "xy");
  EXPECT_EQ(again.cell->volume(), packing.cell->volume());
  ASSERT_NE(find_attribute(again, "f_Temp"), nullptr);
  EXPECT_EQ(find_attribute(again, "f_Temp")->value, packing.attributes[0].value);
}

}  // namespace
}  // namespace superstep
