#include <gtest/gtest.h>

#include "core/error.hpp"
#include "packing/read.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

Packing read_text(const std::string& content, double unit = 1.0) {
  const test::TemporaryFolder folder;
  return read_packing(folder.write("p.csv", content), unit);
}

TEST(ReadCsv, TakesColumnsInAnyOrderWithOptionalOnes) {
  const auto packing =
      read_text("material,radius,z,y,x,id\nsteel,0.5,3,2,1,7\nglass,0.25,6,5,4,-2\nsteel,1,9,8,7,0\n");
  ASSERT_EQ(packing.size(), 3u);
  EXPECT_EQ(packing.id, (std::vector<std::int64_t>{7, -2, 0}));
  EXPECT_EQ(packing.centre[1].x, 4.0);
  EXPECT_EQ(packing.centre[1].z, 6.0);
  EXPECT_EQ(packing.radius[1], 0.25);
  EXPECT_EQ(packing.material_names, (std::vector<std::string>{"steel", "glass"}));
  EXPECT_EQ(packing.material, (std::vector<std::int32_t>{0, 1, 0}));
}

TEST(ReadCsv, NumbersParticlesInFileOrderWithoutIds) {
  const auto packing = read_text("x,y,z,radius\r\n0,0,0,1\r\n\r\n5,0,0,1\r\n");
  EXPECT_EQ(packing.id, (std::vector<std::int64_t>{0, 1}));
  EXPECT_EQ(packing.material, (std::vector<std::int32_t>{0, 0}));
  EXPECT_TRUE(packing.material_names.empty());
}

TEST(ReadCsv, KeepsTheNameOfASingleMaterial) {
  EXPECT_EQ(read_text("x,y,z,radius,material\n0,0,0,1,NiAl\n").material_names,
            std::vector<std::string>{"NiAl"});
}

TEST(ReadCsv, ScalesLengthsToMetres) {
  const auto packing = read_text("\xEF\xBB\xBFid,x,y,z,radius\n1,1,2,-3,+0.5\n", 1e-6);
  EXPECT_DOUBLE_EQ(packing.centre[0].z, -3e-6);
  EXPECT_DOUBLE_EQ(packing.radius[0], 0.5e-6);
}

/// A file, and what its message must say.
struct BadFile {
  std::string name, content;
  std::vector<std::string> says;
};

class RefusedCsv : public testing::TestWithParam<BadFile> {};

TEST_P(RefusedCsv, NamesLineValueAndRule) {
  const auto message = test::message_of<InputError>([] { (void)read_text(GetParam().content); });
  for (const auto& part : GetParam().says) EXPECT_NE(message.find(part), std::string::npos) << message;
}

const std::string header = "id,x,y,z,radius\n";
INSTANTIATE_TEST_SUITE_P(
    Files, RefusedCsv,
    testing::Values(
        BadFile{"MissingColumn", "id,x,y,z\n1,0,0,0\n", {"p.csv:1:", "'radius' is missing"}},
        BadFile{"MisspeltColumn",
                "id,x,y,z,radus\n1,0,0,0,1\n",
                {"p.csv:1:", "'radius' is missing", "is 'radus' meant"}},
        BadFile{"ColumnTwice",
                "id,x,y,z,radius,x\n1,0,0,0,1,0\n2,3,0,0,1,3.5\n",
                {"p.csv:3:", "'x' stands twice", "as '3' and as '3.5'"}},
        BadFile{"ShortRow", header + "1,0,0,0,1\n2,0,0,1\n", {"p.csv:3:", "4 cells", "header has 5"}},
        BadFile{"LongRow", header + "1,0,0,0,1,9\n", {"p.csv:2:", "6 cells"}},
        BadFile{"DecimalComma", header + "1,0,0,0,1,5\n", {"p.csv:2:", "decimal point"}},
        BadFile{"Hexadecimal", header + "1,0x10,0,0,1\n", {"p.csv:2:", "'x' is '0x10'", "decimal number"}},
        BadFile{"TrailingJunk", header + "1,0,0,0,1um\n", {"p.csv:2:", "'radius' is '1um'"}},
        BadFile{"Overflow", header + "1,1e999,0,0,1\n", {"p.csv:2:", "'x' is '1e999'", "finite"}},
        BadFile{"NotANumber", header + "1,0,nan,0,1\n", {"p.csv:2:", "'y' is 'nan'", "finite"}},
        BadFile{"Infinite", header + "1,0,0,0,inf\n", {"p.csv:2:", "'radius' is 'inf'", "finite"}},
        BadFile{"EmptyCell", header + "1,0,,0,1\n", {"p.csv:2:", "'y' is ''"}},
        BadFile{"NegativeRadius", header + "1,0,0,0,-1\n", {"p.csv:2:", "radius is -1;", "must be > 0"}},
        BadFile{"ZeroRadius", header + "1,0,0,0,0\n", {"p.csv:2:", "radius is 0;", "must be > 0"}},
        BadFile{"VanishingRadius", header + "1,0,0,0,1e-300\n", {"p.csv:2:", "1e-300", "length unit"}},
        BadFile{"EndlessLength", header + "1,1e200,0,0,1\n", {"p.csv:2:", "x is 1e+200", "length unit"}},
        BadFile{"FractionalId", header + "1.5,0,0,0,1\n", {"p.csv:2:", "'id' is '1.5'", "integer"}},
        BadFile{"HugeId", header + "99999999999999999999,0,0,0,1\n", {"p.csv:2:", "'id'", "integer"}},
        BadFile{"RepeatedId",
                header + "5,0,0,0,1\n\n3,4,0,0,1\n5,8,0,0,1\n",
                {"p.csv:5:", "id is 5, as on line 2", "unique"}},
        BadFile{"CoincidentCentres",
                header + "1,0,0,0,1\n2,3,0,0,1\n3,-0,0,-0,2\n",
                {"p.csv:4:", "as on line 2", "centres must differ"}},
        BadFile{"NoName", "x,y,z,radius,material\n0,0,0,1,\n", {"p.csv:2:", "'material' is ''"}},
        BadFile{"OnlyHeader", header, {"p.csv:", "no particles"}}, BadFile{"Empty", "", {"p.csv:", "empty"}},
        BadFile{"Blank", " \n\r\n", {"p.csv:", "empty"}},
        BadFile{"Binary", header + std::string("1,0\0,0,0,1\n", 12), {"p.csv:", "binary"}},
        BadFile{"Prose", "these are not spheres\n", {"p.csv:1:", "none of the known formats"}}),
    [](const auto& file) { return file.param.name; });

TEST(ReadPacking, RefusesWhatIsNotAFile) {
  const test::TemporaryFolder folder;
  const auto directory = folder.file("");
  EXPECT_NE(test::message_of<InputError>([&] { (void)read_packing(directory); }).find("directory"),
            std::string::npos);
  const auto missing = folder.file("none.csv");
  EXPECT_NE(test::message_of<InputError>([&] { (void)read_packing(missing); }).find("no such file"),
            std::string::npos);
}

TEST(LengthUnit, KnowsItsNamesAndRefusesOthers) {
  EXPECT_EQ(length_unit("m", "c.toml:3"), 1.0);
  EXPECT_EQ(length_unit("um", "c.toml:3"), 1e-6);
  EXPECT_EQ(length_unit("nm", "c.toml:3"), 1e-9);
  const auto message = test::message_of<InputError>([] { (void)length_unit("inch", "c.toml:3"); });
  EXPECT_EQ(message, "c.toml:3: length unit is 'inch'; valid are: m, cm, mm, um, nm");
}

}  // namespace
}  // namespace superstep
