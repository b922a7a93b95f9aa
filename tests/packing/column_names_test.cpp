/// What columns mean by their names: positions of one kind, nothing twice, units, what users declare.

#include <gtest/gtest.h>

#include <algorithm>

#include "support/packing_text.hpp"

namespace superstep {
namespace {

using test::expect_says;
using test::read_as;
using test::refusal;

std::string dump_of(const std::string& columns, const std::string& rows) {
  return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n-4 4\n-4 4\n-4 4\nITEM: "
         "ATOMS " +
         columns + "\n" + rows;
}

PackingOptions declared(std::vector<std::string> columns) {
  PackingOptions options;
  options.columns = std::move(columns);
  return options;
}

TEST(ColumnNames, APositionIsTakenFromNamesOfOneKind) {
  const auto points = read_as("a.csv", "radius,Z,Points:0,Points:1,Points:2\n0.5,7,0,0,1\n0.5,8,3,0,2\n");
  EXPECT_EQ(points.centre[1].z, 2);
  ASSERT_NE(find_attribute(points, "Z"), nullptr) << "a lone Z is no coordinate beside three others";
  const auto frame = read_as("a.xyz", "2\nProperties=pos:R:3:radius:R:1:z:R:1\n0 0 1 0.5 7\n0 0 2 0.5 8\n");
  EXPECT_EQ(frame.centre[1].z, 2);
  EXPECT_EQ(find_attribute(frame, "z")->value, (std::vector<double>{7, 8}));
  const auto whole =
      read_as("a.xyz", "1\nProperties=x:R:1:y:R:1:z:R:1:pos:R:3:radius:R:1\n7 8 9 0 0 1 0.5\n");
  EXPECT_EQ(whole.centre[0].z, 1) << "pos is the position by the format, whatever else is there";
  const auto dump = read_as("a.dump", dump_of("id z xu yu zu radius", "1 7 0 0 1 0.5\n2 8 0 0 2 0.5\n"));
  EXPECT_EQ(dump.centre[1].z, 2);
  expect_says(refusal("x,y,Points:2,radius\n0,0,0,1\n"), {"'x' and 'y' and 'Points:2'", "different kinds"});
  expect_says(refusal("x,y,radius\n0,0,1\n"), {"'z' is missing"});
}

TEST(ColumnNames, TwoPositionsMustAgree) {
  const std::string names = "x,y,z,Points:0,Points:1,Points:2,radius\n";
  EXPECT_EQ(read_as("a.csv", names + "1,2,3,1,2,3,0.5\n").centre[0].z, 3);
  expect_says(refusal(names + "1,2,3,1,2,4,0.5\n"),
              {"p.txt:2:", "'x' 'y' 'z'", "'Points:0' 'Points:1' 'Points:2'"});
  EXPECT_EQ(read_as("a.dump", dump_of("id x y z xu yu zu radius", "1 0 0 1 0 0 9 0.5\n2 0 0 2 0 0 2 0.5\n"))
                .centre[0]
                .z,
            1)
      << "unwrapped positions are others by their nature";
}

TEST(ColumnNames, NamesThatDifferInCaseAloneStandTwice) {
  expect_says(refusal("x,y,z,r,R\n0,0,0,0.8,0.5\n"), {"p.txt:1:", "'r' and 'R'", "mean the same"});
  expect_says(refusal("x,y,z,Radius,radius\n0,0,0,0.8,0.5\n"), {"'Radius' and 'radius'"});
  expect_says(refusal("x,y,z,Z,radius\n0,0,0,4,0.5\n"), {"'z' and 'Z'"});
  expect_says(refusal("id,ID,x,y,z,radius\n1,2,0,0,0,0.5\n"), {"'id' and 'ID'"});
  expect_says(refusal("x [mm],x,y [mm],z [mm],r [mm]\n1,2,0,0,0.5\n"), {"'x [mm]' and 'x'"});
  const auto packing = read_as("a.csv", "x,y,z,radius,r,R\n0,0,0,0.5,0.8,7\n");
  EXPECT_EQ(packing.radius[0], 0.5);
  EXPECT_EQ(packing.attributes.size(), 2u) << "beside a radius, r and R are something else";
}

TEST(ColumnNames, PrefixesOfLammpsBeginAttributes) {
  const auto dump = read_as("a.dump", dump_of("id x y z radius d_m", "1 0 0 0 0.55 7\n2 0 0 1 0.55 8\n"));
  EXPECT_EQ(find_attribute(dump, "d_m")->value, (std::vector<double>{7, 8}));
  EXPECT_EQ(read_as("a.csv", "x_m,y_m,z_m,d_m\n0,0,0,3\n").radius[0], 1.5) << "in a table it is a unit";
}

TEST(ColumnNames, LettersBeyondAsciiAreNotDropped) {
  for (const std::string micro : {"\xC2\xB5", "\xCE\xBC", "\xC2\xB5m", "\xCE\xBCm"})
    EXPECT_DOUBLE_EQ(read_as("a.csv", "x (" + micro + "),y (" + micro + "),z (" + micro + "),radius (" +
                                          micro + ")\n0,0,0,2\n")
                         .radius[0],
                     2e-6)
        << micro;
  for (const std::string angstrom : {"\xC3\x85", "\xE2\x84\xAB", "Angstrom", "\xC3\x85ngstr\xC3\xB6m"})
    EXPECT_DOUBLE_EQ(read_as("a.csv", "x [" + angstrom + "],y [" + angstrom + "],z [" + angstrom + "],r [" +
                                          angstrom + "]\n0,0,0,2\n")
                         .radius[0],
                     2e-10)
        << angstrom;
  EXPECT_DOUBLE_EQ(read_as("a.csv", "x_\xC3\x85,y_\xC3\x85,z_\xC3\x85,r_\xC3\x85\n0,0,0,2\n").radius[0],
                   2e-10);
  expect_says(refusal("x,y,z,radius [\xC3\x85]\n0,0,0,2\n"), {"units for some"});
  expect_says(refusal("x [\xC3\x86],y [\xC3\x86],z [\xC3\x86],radius [\xC3\x86]\n0,0,0,2\n"),
              {"'x [\xC3\x86]' states the unit '\xC3\x86'"});
  expect_says(refusal("x,y,z,radius [furlong]\n0,0,0,2\n"), {"'radius [furlong]' states the unit"});
}

TEST(ColumnNames, RadiusAndDiameterHaveUnitsOfTheirOwn) {
  const std::string positions = "x [mm],y [mm],z [mm],";
  expect_says(refusal(positions + "radius [mm],diameter [um]\n0,0,0,0.5,1\n"),
              {"radius is 0.5 and diameter 1"});
  const auto packing = read_as("a.csv", positions + "radius [um],diameter [mm]\n0,0,0,550,1.1\n");
  EXPECT_DOUBLE_EQ(packing.radius[0], 550e-6);
  expect_says(refusal(positions + "radius [mm],diameter\n0,0,0,0.5,1\n"), {"units for some"});
}

TEST(ColumnNames, DeclaredOnesDoNotContradictThoseOfTheFile) {
  expect_says(refusal(dump_of("id x y z radius", "1 0 0 0 0.5\n2 0 0 1 0.5\n"),
                      declared({"id", "radius", "x", "y", "z"})),
              {"columns", "LAMMPS/LIGGGHTS dump", "leave it out"});
  expect_says(refusal("x,y,z,diameter\n0,0,0,1\n", declared({"x", "y", "z", "radius"})),
              {"column 4 'radius'", "'diameter'"});
  expect_says(
      refusal("x [mm],y [mm],z [mm],r [mm]\n0,0,0,1\n", declared({"x [um]", "y [um]", "z [um]", "r [um]"})),
      {"column 1 'x [um]'", "'x [mm]'"});
  expect_says(refusal("1\nProperties=pos:R:3:radius:R:1\n0 0 0 1\n", declared({"radius", "x", "y", "z"})),
              {"column 1 'radius'"});
  EXPECT_EQ(read_as("a.csv", "x,y,z,R\n0,0,0,1\n", declared({"x", "y", "z", "radius"})).radius[0], 1);
  EXPECT_EQ(read_as("a.csv", "a;b;c;e\n0;0;0;1\n", declared({"x", "y", "z", "diameter"})).radius[0], 0.5)
      << "names that mean nothing may be replaced";
  PackingOptions style;
  style.atom_style = "hybrid sphere";
  const auto data = read_as("a.data",
                            "t\n\n1 atoms\n1 atom types\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nAtoms # "
                            "sphere\n\n1 1 0.5 2.5 3 4 1.5\n",
                            style);
  EXPECT_TRUE(test::warns(data, "states the style sphere")) << "a style may be wrong, and then it is said";
}

/// As LIGGGHTS writes it where a script asks for `type type`.
TEST(ColumnNames, TheSameColumnAgainIsNoMatterWhereItsValuesAreTheSame) {
  const auto dump = [](const std::string& names, const std::string& rows) {
    return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n-5 5\n-5 5\n-5 5\nITEM: "
           "ATOMS " +
           names + "\n" + rows;
  };
  const auto packing = read_as("a.dump", dump("id type type x y z x radius fx fx fx",
                                              "1 1 1 0 0 0 0 0.5 7 7 7\n2 2 2 1 0 0 1.0 0.5 nan nan nan\n"));
  EXPECT_EQ(packing.centre[1].x, 1);
  EXPECT_EQ(packing.material_names, (std::vector<std::string>{"1", "2"}));
  ASSERT_EQ(packing.attributes.size(), 1u);
  EXPECT_EQ(packing.attributes[0].name, "fx");
  EXPECT_TRUE(std::find(packing.notes.begin(), packing.notes.end(),
                        "column 'type' stands twice, with the same values") != packing.notes.end());
  expect_says(refusal(dump("id type type x y z radius", "1 1 1 0 0 0 0.5\n2 2 1 1 0 0 0.5\n")),
              {"p.txt:11:", "'type' stands twice in 'ITEM: ATOMS", "as '2' and as '1'"});
  expect_says(refusal("x,y,z,radius,q,q\n0,0,0,1,5,\n"), {"p.txt:2:", "'q' stands twice"});
}

TEST(ColumnNames, SeveralTimeStepsAreNotLaidOnTopOfEachOther) {
  const std::string rows = "0,0,0,0,0.5\n0,0,0,1,0.5\n1,0,0,0.4,0.5\n1,0,0,1.4,0.5\n";
  for (const char* name : {"TimeStep", "Time", "time [s]", "time_step", "frame", "Frame", "STEP", "step"})
    expect_says(refusal(std::string(name) + ",Points:0,Points:1,Points:2,radius\n" + rows),
                {"p.txt:4:", name, "several time steps", "export one"});
  EXPECT_EQ(read_as("a.csv", "TimeStep,x,y,z,radius\n5,0,0,0,0.5\n5,0,0,1,0.5\n").size(), 2u);
}

}  // namespace
}  // namespace superstep
