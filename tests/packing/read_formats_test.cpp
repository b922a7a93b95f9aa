#include <gtest/gtest.h>

#include "core/error.hpp"
#include "packing/formats/packing_builder.hpp"
#include "packing/read.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using Ids = std::vector<std::int64_t>;
using Names = std::vector<std::string>;

Packing read_text(const std::string& content, double unit = 1.0) {
  const test::TemporaryFolder folder;
  return read_packing(folder.write("p.txt", content), unit);
}

std::string refusal(const std::string& content) {
  return test::message_of<InputError>([&] { (void)read_text(content); });
}

void expect_says(const std::string& message, const std::vector<std::string>& parts) {
  for (const auto& part : parts) EXPECT_NE(message.find(part), std::string::npos) << message;
}

std::string dump_frame(const std::string& count, const std::string& columns, const std::string& rows) {
  return "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n" + count +
         "\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\nITEM: ATOMS " + columns + "\n" + rows;
}

TEST(ReadLammpsDump, TakesTheLastFrameAndColumnsInAnyOrder) {
  const auto packing =
      read_text(dump_frame("1", "id x y z radius", "1 0 0 0 9\n") +
                    dump_frame("2", "radius vx z y x type id ", "0.5 7 3 2 1 1 12 \n0.25 7 6 5 4 2 3 \n"),
                1e-3);
  EXPECT_EQ(packing.id, (Ids{12, 3}));
  EXPECT_DOUBLE_EQ(packing.centre[0].x, 1e-3);
  EXPECT_DOUBLE_EQ(packing.centre[1].z, 6e-3);
  EXPECT_DOUBLE_EQ(packing.radius[0], 0.5e-3);
  EXPECT_EQ(packing.material_names, (Names{"1", "2"}));
  EXPECT_EQ(packing.material, (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(packing.frame, "the last of 2 frames, time step 100");
}

TEST(ReadLammpsDump, HalvesDiametersAndDoesWithoutIdsAndTypes) {
  const auto packing = read_text(dump_frame("2", "x y z diameter", "0 0 0 1\n2 0 0 3\n"));
  EXPECT_EQ(packing.id, (Ids{0, 1}));
  EXPECT_EQ(packing.radius, (std::vector<double>{0.5, 1.5}));
  EXPECT_TRUE(packing.material_names.empty());
  EXPECT_EQ(packing.frame, "") << "there is no choice";
}

TEST(ReadLammpsDump, ASingleTypeIsNoMaterial) {
  const auto packing = read_text(dump_frame("2", "type x y z radius", "4 0 0 0 1\n4 3 0 0 1\n"));
  EXPECT_TRUE(packing.material_names.empty());
  EXPECT_EQ(packing.material, (std::vector<std::int32_t>{0, 0}));
}

TEST(ReadLammpsDump, RefusesBadFramesByLine) {
  expect_says(refusal(dump_frame("1", "id x y z", "1 0 0 0\n")),
              {"p.txt:9:", "'radius' is missing", "diameter"});
  expect_says(refusal(dump_frame("1", "id px py pz radius", "1 0 0 0 1\n")), {"p.txt:9:", "'x' is missing"});
  expect_says(refusal(dump_frame("1", "x y z radius", "0 0 0\n")), {"p.txt:10:", "3 columns", "must have 4"});
  expect_says(refusal(dump_frame("1", "x y z radius", "0 0 0,5 1\n")),
              {"p.txt:10:", "'z' is '0,5'", "decimal"});
  expect_says(refusal(dump_frame("1", "x y z radius", "0 0 0 -1\n")), {"p.txt:10:", "radius is -1", "> 0"});
  expect_says(refusal(dump_frame("1.5", "x y z radius", "0 0 0 1\n")), {"p.txt:4:", "'1.5'", "integer"});
  const auto two = dump_frame("2", "id x y z radius", "1 0 0 0 1\n1 3 0 0 1\n");
  expect_says(refusal(two), {"p.txt:11:", "id is 1, as on line 10"});
  expect_says(refusal(two + two), {"p.txt:22:", "id is 1, as on line 21"});
  expect_says(refusal(dump_frame("3", "x y z radius", "0 0 0 1\n3 0 0 1\n")),
              {"p.txt:11:", "after 2 atoms", "announces 3"});
  expect_says(refusal(dump_frame("1", "x y z radius", "0 0 0 1\n3 0 0 1\n")),
              {"after 2 atoms", "announces 1"});
  expect_says(refusal(dump_frame("0", "x y z radius", "")), {"no particles"});
  expect_says(refusal("ITEM: ATOMS x y z radius\n0 0 0 1\n"), {"ITEM: TIMESTEP"});
}

const std::string data_head =
    "LAMMPS data file, 3 atoms or so\n\n2 atoms\n2 atom types\n\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\n";

TEST(ReadLammpsDump, AFrameThatDoesNotCountItsAtomsMayBeCutOff) {
  expect_says(refusal("ITEM: TIMESTEP\n100\nITEM: ATOMS id x y z radius\n1 0 0 0 1\n"),
              {"p.txt:", "no 'ITEM: NUMBER OF ATOMS'"});
}

TEST(ReadLammpsData, ARowThatBeginsWithABrokenNumberEndsNoSection) {
  const auto data = [](const std::string& row) {  // the header announces what would be left
    return "title\n\n1 atoms\n\nAtoms # sphere\n\n1 1 1.0 1000 0 0 0\n" + row + "\n3 1 1.0 1000 4 0 0\n";
  };
  for (const char* row : {"nan 1 1.0 1000 2 0 0", "-nan 1 1.0 1000 2 0 0", "Infinity 1 1.0 1000 2 0 0", "NaN",
                          "two 1 1.0 1000 2 0 0"})
    expect_says(refusal(data(row)), {"p.txt:8:"});
}

TEST(ReadLammpsData, ReadsTheAtomsSectionOnly) {
  const auto packing = read_text(
      data_head +
          "Masses\n\n1 5\n2 6\n\nAtoms # sphere\n\n2 1 4.0 2500 1 2 3 0 0 0\n1 2 2.0 2500 5 6 7 0 0 0 # x\n\n"
          "Velocities\n\n1 0 0 0\n2 0 0 0\n",
      1e-2);
  EXPECT_EQ(packing.id, (Ids{2, 1}));
  EXPECT_DOUBLE_EQ(packing.radius[0], 2e-2);
  EXPECT_DOUBLE_EQ(packing.centre[1].z, 7e-2);
  EXPECT_EQ(packing.material_names, (Names{"1", "2"}));
}

TEST(ReadLammpsData, RefusesBadSectionsByLine) {
  expect_says(refusal(data_head + "Atoms\n\n1 1 1.0 2500 0 0\n"),
              {"p.txt:12:", "6 columns", "diameter density x y z"});
  expect_says(refusal(data_head + "Atoms # bond\n\n1 1 0 0 0\n"),
              {"p.txt:10:", "'bond'", "sphere or granular"});
  expect_says(refusal(data_head + "Atoms\n\n1 1 1.0 2500 0 0 0\n"), {"'Atoms' has 1 rows", "announces 2"});
  expect_says(refusal(data_head + "Atoms\n\n1 1 0 2500 0 0 0\n2 1 1 2500 0 0 0\n"),
              {"p.txt:12:", "radius is 0"});
  expect_says(refusal(data_head + "Atoms\n\n1 1 1 2500 0 0 0\n2 1 1 2500 0 0 0\n"),
              {"p.txt:13:", "as on line 12"});
  expect_says(refusal("title\n0 atoms\n\nAtoms\n"), {"no particles"});
}

TEST(ReadYade, ReadsBothFormats) {
  const auto plain = read_text("#format x_y_z_r\n# made by hand\n0 0 0 1\n3\t0 0 0.5\n");
  EXPECT_EQ(plain.radius, (std::vector<double>{1.0, 0.5}));
  EXPECT_TRUE(plain.material_names.empty());
  const auto mixed = read_text("#format x_y_z_r_matId\n0 0 0 1 0\n3 0 0 0.5 7\n");
  EXPECT_EQ(mixed.material_names, (Names{"0", "7"}));
  EXPECT_EQ(mixed.id, (Ids{0, 1}));
}

TEST(ReadYade, RefusesBadRowsByLine) {
  expect_says(refusal("#format x_y_z\n0 0 0\n"), {"p.txt:1:", "x_y_z", "x_y_z_r_matId"});
  expect_says(refusal("#format x_y_z_r_matId\n0 0 0 1\n"), {"p.txt:2:", "4 columns", "must have 5"});
  expect_says(refusal("#format x_y_z_r\n0 0 0 1\n0 0 0x1 1\n"), {"p.txt:3:", "'z' is '0x1'"});
  expect_says(refusal("#format x_y_z_r\n"), {"no particles"});
}

std::string mercury_row(const std::string& centre, const std::string& radius, const std::string& species) {
  return centre + " 0 0 0 " + radius + " 0 0 0 0 0 0 " + species + "\n";
}

TEST(ReadYade, AFormatBelowParticlesIsRefusedSinceRowsMustAllHaveAMaterialOrNone) {
  expect_says(refusal("#format x_y_z_r\n0 0 0 1\n#format x_y_z_r_matId\n3 0 0 1 a\n6 0 0 1 b\n"),
              {"p.txt:3:", "above"});
  expect_says(refusal("#format x_y_z_r_matId\n0 0 0 1 a\n3 0 0 1 b\n#format x_y_z_r\n6 0 0 1\n"),
              {"p.txt:4:", "above"});
}

TEST(PackingBuilder, RowsAllHaveAMaterialOrNone) {
  using Step = void (*)(PackingBuilder&);
  const Step plain = [](PackingBuilder& b) { b.add(10 + b.size(), 0, {3.0 * double(b.size()), 0, 0}, 1); };
  const Step named = [](PackingBuilder& b) {
    b.add(10 + b.size(), 0, {3.0 * double(b.size()), 0, 0}, 1);
    b.set_material("a");
  };
  const auto built = [](std::vector<Step> steps) {
    return test::message_of<InputError>([&] {
      PackingBuilder builder("p.txt", 1);
      for (const auto step : steps) step(builder);
      (void)builder.finish();
    });
  };
  expect_says(built({plain, named}), {"p.txt:11:", "material"});
  expect_says(built({named, plain, named}), {"p.txt:11:", "material"});
  expect_says(built({named, plain}), {"p.txt:11:", "material"});
}

TEST(ReadMercury, TakesTheLastFrame) {
  const auto packing =
      read_text("1 0.5 0 0 0 1 1 1\n" + mercury_row("9 9 9", "9", "0") + "2 1.0 0 0 0 1 1 1\n" +
                mercury_row("1 2 3", "0.5", "0") + mercury_row("4 5 6", "0.25", "3") + "\n");
  ASSERT_EQ(packing.size(), 2u);
  EXPECT_EQ(packing.centre[1].y, 5.0);
  EXPECT_EQ(packing.radius, (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(packing.material_names, (Names{"0", "3"}));
  EXPECT_EQ(packing.frame, "the last of 2 frames, t = 1");
}

TEST(ReadMercury, RefusesBadFramesByLine) {
  const std::string head = "2 1.0 0 0 0 1 1 1\n", row = mercury_row("0 0 0", "1", "0");
  expect_says(refusal(head + row), {"p.txt:2:", "after 1 particles", "line 1 announces 2"});
  expect_says(refusal(head + row + "0 0 0 1\n"), {"p.txt:3:", "4 columns", "must have 14"});
  expect_says(refusal(head + row + row), {"p.txt:3:", "as on line 2", "centres must differ"});
  expect_says(refusal(head + row + mercury_row("3 0 0", "-1", "0")), {"p.txt:3:", "radius is -1"});
  expect_says(refusal("0 1.0 0 0 0 1 1 1\n"), {"no particles"});
  expect_says(refusal(head + row + mercury_row("3 0 0", "1", "0") + "7 8\n"),
              {"p.txt:4:", "header of a frame"});
}

}  // namespace
}  // namespace superstep
