/// Cases that take what people have: profiles, columns, gaps, bonds, selections, matrices, periodic dumps.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "case/checks/effective.hpp"
#include "case/packed/starter_case.hpp"
#include "case/scene.hpp"
#include "packing/read.hpp"
#include "support/case_texts.hpp"

namespace superstep {
namespace {

using test::values_at_end;

class Inputs : public test::CaseTexts {
 protected:
  /// Four spheres in a row that overlap by 2 %, ids 1 to 4.
  void write_row() {
    folder_.write("row.csv",
                  "id,x,y,z,r,temperature\n1,0,0,0,1e-3,10\n2,0,0,1.98e-3,1e-3,20\n3,0,0,3.96e-3,1e-3,30\n4,"
                  "0,0,5.94e-3,1e-3,40\n");
  }
  static std::string row_case(const std::string& thermal, const std::string& contact = "neck = \"hertz\"",
                              const std::string& packing = "file = \"row.csv\"",
                              const std::string& material = "[material]\ndensity = 2500\n") {
    return "t_end = 100\n[packing]\n" + packing + "\n[contact]\n" + contact + "\n" + material +
           "[thermal]\nconductivity = 1.0\nspecific_heat = 800\n" + thermal + "\n";
  }
  static std::string several(const std::string& one, const std::string& other) {
    return "[[materials]]\nname = \"heavy\"\ndensity = 8000\nthermal = { conductivity = 1, specific_heat = 1 "
           "}\n" +
           one +
           "\n[[materials]]\nname = \"light\"\ndensity = 1000\nthermal = { conductivity = 1, specific_heat = "
           "1 }\n" +
           other + "\n";
  }
};

TEST_F(Inputs, ProfilesComeFromFilesWithStepsScalesAndPeriods) {
  write_row();
  folder_.write("p.csv", "time [s];power\n0;1\n10;1\n10;3\n20;5\n");
  const auto table = [&](const std::string& more) {
    return load(row_case("source = [ { where = \"all\", value = { file = \"p.csv\", time = \"time [s]\", "
                         "value = \"power\"" +
                         more + " } } ]"))
        .fields[0]
        .graph.tables[0];
  };
  const auto plain = table("");
  EXPECT_EQ(plain.at(9.999), 1);
  EXPECT_EQ(plain.at(10), 3) << "two equal times are a step";
  EXPECT_EQ(plain.at(15), 4);
  EXPECT_EQ(plain.at(90), 5) << "the end value holds";
  EXPECT_EQ(table(", scale = 1e-3").at(15), 4e-3);
  const auto repeated = table(", period = 25");
  EXPECT_EQ(repeated.at(10 + 75), 3);
  EXPECT_DOUBLE_EQ(repeated.at(22.5), 3) << "from 5 back to 1";
  EXPECT_EQ(repeated.time.back() >= 100, true);
  const auto seam = table(", period = 20");
  EXPECT_EQ(seam.at(20), 1) << "a step where the next turn begins";
  EXPECT_EQ(seam.before(20), 5);
  const auto zero = table(", outside = \"zero\"");
  EXPECT_EQ(zero.at(50), 0);
  EXPECT_EQ(zero.before(20), 5);
  EXPECT_EQ(zero.at(0), 1);
}

/// k * period and the end of the turn before it are rounded differently, and are one instant all the same.
TEST_F(Inputs, InstantsThatDifferByRoundingsAreOne) {
  write_row();
  const auto table = [&](const std::string& value) {
    return load(row_case("source = [ { where = \"all\", value = " + value + " } ]"))
        .fields[0]
        .graph.tables[0];
  };
  for (const char* period : {"0.1", "0.02", "0.05", "0.3", "0.6", "0.7"}) {
    const std::string half = std::to_string(0.5 * std::stod(period));
    const auto square = table("{ times = [0, " + half + ", " + half + ", " + period +
                              "], values = [1, 1, 0, 0], period = " + period + " }");
    const auto saw =
        table("{ times = [0, " + std::string(period) + "], values = [0, 1], period = " + period + " }");
    for (const auto& one : {square, saw})
      for (std::size_t k = 1; k < one.time.size(); ++k)
        ASSERT_TRUE(one.time[k] == one.time[k - 1] || one.time[k] > one.time[k - 1] + 1e-3)
            << period << ": " << one.time[k] - one.time[k - 1];
  }
  // 0.4 - 0.1 is a rounding more than 0.3, and 1.2 + 0.1 more than 1.3.
  EXPECT_DOUBLE_EQ(table("{ times = [0.1, 0.4], values = [0, 1], period = 0.3 }").at(0.25), 0.5);
  EXPECT_EQ(
      table("{ times = [0, 1.3000000000000003, 1.3, 2], values = [1, 1, 4, 4] }").at(1.3000000000000003), 4);
}

TEST_F(Inputs, BadProfilesSayWhatIsWrong) {
  write_row();
  const auto with = [&](const std::string& value) {
    return row_case("source = [ { where = \"all\", value = " + value + " } ]");
  };
  folder_.write("p.csv", "time,value\n0,1\n5,2\n3,4\n");
  expect_refused(with("{ file = \"p.csv\" }"), "p.csv:4: the times must be ascending");
  folder_.write("p.csv", "time,value\n0,1\n5,2\n5,2\n5,4\n");
  expect_refused(with("{ file = \"p.csv\" }"), "stands three times");
  folder_.write("p.csv", "time,value\n0,1\n5,x\n");
  expect_refused(with("{ file = \"p.csv\" }"), "p.csv:3: column 'value' is 'x'");
  expect_refused(with("{ file = \"p.csv\", value = \"power\" }"), "no column 'power'");
  folder_.write("p.csv", "t [ms],P [mW],Q [W]\n0,1,1\n50,2,2\n");
  expect_refused(with("{ file = \"p.csv\", time = \"t [ms]\", value = \"Q [W]\" }"), "times must be in s");
  folder_.write("p.csv", "t [s],P [mW],Q [W]\n0,1,1\n50,2,2\n");
  expect_refused(with("{ file = \"p.csv\", time = \"t [s]\", value = \"P [mW]\" }"),
                 "is in mW; values must be in");
  EXPECT_EQ(load(with("{ file = \"p.csv\", time = \"t [s]\", value = \"P [mW]\", scale = 1e-3 }"))
                .fields[0]
                .graph.tables[0]
                .at(50),
            2e-3);
  folder_.write("p.csv", "0 1\n50 2\n");
  expect_refused(with("{ file = \"p.csv\", outside = \"error\" }"), "holds from 0 to 50 s");
  expect_refused(with("{ file = \"p.csv\", period = 10 }"), "must not be longer than its period");
  expect_refused(with("{ file = \"p.csv\", period = 60, outside = \"zero\" }"), "no outside");
  expect_refused(with("{ file = \"p.csv\", times = [0], values = [1] }"), "either a file");
  expect_refused(with("{ times = [0, 1e-9], values = [0, 1], period = 1e-9 }"), "more than");
  // Turns that no double counts: adding one to their number changes nothing.
  expect_refused(with("{ times = [1e39], values = [1], period = 1e-300 }"), "it is nothing beside");
  expect_refused(with("{ times = [-1e30], values = [1], period = 1.0 }"), "it is nothing beside");
  EXPECT_EQ(load(with("{ file = \"p.csv\" }")).fields[0].graph.tables[0].at(25), 1.5)
      << "two columns need no names";
}

/// Two surroundings of one particle see parts of its surface, which are no more than all of it.
TEST_F(Inputs, EmissivitiesOfAParticleAddUpToNoMoreThanOne) {
  write_row();
  const auto with = [&](const char* second) {
    return row_case(
        fmt::format("initial = 300\nradiation = [ {{ where = \"all\", emissivity = 0.7, ambient = 300 }}, "
                    "{{ where = {{ ids = [2] }}, emissivity = {}, ambient = 400 }} ]",
                    second));
  };
  EXPECT_EQ(load(with("0.3")).fields[0].graph.radiation.size(), 5U);
  expect_refused(with("0.4"),
                 "particle 2 is in an earlier selection, too, and would radiate with an emissivity of 1.1");
}

/// Held values follow nothing: what feeds held particles alone is a mistake that no result shows.
TEST_F(Inputs, WhatFeedsFixedParticlesAloneIsWarnedOf) {
  write_row();
  const auto notes = [&](const std::string& ids) {
    const auto scene =
        load(row_case("initial = 300\nfixed = [ { where = { ids = [1, 2] }, value = 300.0 } ]\n"
                      "source = [ { where = { ids = [" +
                      ids + "] }, value = 1.0 } ]\nconvection = [ { where = { ids = [" + ids +
                      "] }, coefficient = 5, ambient = 300 } ]\nradiation = [ { where = { ids = [" + ids +
                      "] }, emissivity = 0.5, ambient = 300 } ]"));
    std::string all;
    for (const auto& warning : scene.warnings) all += warning + "\n";
    return all;
  };
  const std::string held = notes("2, 1"), both = notes("2, 3");
  for (const char* key : {"source", "convection", "radiation"}) {
    const std::string place = fmt::format("key 'thermal.{}[0].where' selects fixed particles alone", key);
    EXPECT_NE(held.find(place), std::string::npos) << held;
  }
  EXPECT_EQ(both.find("fixed particles alone"), std::string::npos) << both;
}

TEST_F(Inputs, AFileWhoseSpheresSwallowEachOtherIsNamedOnce) {
  folder_.write("row.csv", "id,x,y,z,r\n1,0,0,0,1e-3\n2,0,0,1e-4,5e-4\n");
  const std::string message = refusal(row_case("")), name = "row.csv: ";
  const auto first = message.find(name);
  ASSERT_NE(first, std::string::npos) << message;
  EXPECT_EQ(message.find(name, first + 1), std::string::npos) << message;
}

TEST_F(Inputs, TensOfThousandsOfPointsAreNoTrouble) {
  write_row();
  std::string text = "t,u\n";
  for (int k = 0; k <= 50000; ++k)
    text += std::to_string(k * 2e-3) + "," + std::to_string(std::sin(k * 0.01)) + "\n";
  folder_.write("p.csv", text);
  const auto scene = load(row_case(
      "fixed = [ { where = { ids = [1] }, value = { file = \"p.csv\", time = \"t\", value = \"u\" } } ]"));
  EXPECT_EQ(scene.fields[0].graph.tables[0].time.size(), 50001u);
}

TEST_F(Inputs, InitialTemperaturesPerParticle) {
  write_row();
  EXPECT_EQ(load(row_case("initial = { column = \"Temperature\" }")).fields[0].graph.initial,
            (std::vector<double>{10, 20, 30, 40}));
  folder_.write("start.csv", "temperature,id\n4,4\n3,3\n1,1\n2,2\n");
  EXPECT_EQ(
      load(row_case("initial = { file = \"start.csv\", column = \"temperature\" }")).fields[0].graph.initial,
      (std::vector<double>{1, 2, 3, 4}));
  expect_refused(row_case("initial = { column = \"temp\" }"), "those are temperature");
  folder_.write("start.csv", "id,temperature\n1,1\n2,2\n3,3\n");
  expect_refused(row_case("initial = { file = \"start.csv\", column = \"temperature\" }"), "no row for id 4");
  folder_.write("start.csv", "id,temperature\n1,1\n2,2\n3,3\n4,4\n9,9\n");
  expect_refused(row_case("initial = { file = \"start.csv\", column = \"temperature\" }"), "id is '9'");
  folder_.write("row.csv", "id,x,y,z,r,temperature\n1,0,0,0,1,nan\n");
  expect_refused(row_case("initial = { column = \"temperature\" }"), "no number for particle 1");
}

TEST_F(Inputs, GapsAndBondsJoinParticlesThatDoNotOverlap) {
  folder_.write("row.csv", "id,x,y,z,r\n1,0,0,0,1\n2,0,0,2,1\n3,0,0,4.005,1\n4,0,0,7,1\n");
  const std::string mm = "file = \"row.csv\"\nlength_unit = \"mm\"";
  const auto bare = load(row_case("", "neck = \"hertz\"", mm));
  EXPECT_EQ(bare.packed->contacts.size(), 0u);
  EXPECT_NE(bare.warnings.back().find("[contact] gap"), std::string::npos) << bare.warnings.back();
  const auto joined = load(row_case("", "neck = \"hertz\"\ngap = 0.01\nbond_radius = 0.25", mm));
  ASSERT_EQ(joined.packed->contacts.size(), 2u);
  EXPECT_DOUBLE_EQ(joined.packed->contacts.neck_radius[1], 0.25e-3);
  expect_refused(row_case("", "neck = \"hertz\"\ngap = 0.01", mm), "bond_radius");
  folder_.write("bonds.csv", "3 4 0.5\n2 1 0.125\n");
  const auto bonded =
      load(row_case("", "neck = \"hertz\"\ngap = 0.01\nbond_radius = 0.25\nbonds = \"bonds.csv\"", mm));
  EXPECT_EQ(bonded.packed->contacts.i, (std::vector<std::int32_t>{0, 1, 2}));
  EXPECT_EQ(bonded.packed->contacts.neck_radius, (std::vector<double>{0.125e-3, 0.25e-3, 0.5e-3}));
  expect_refused(row_case("", "neck = \"given\"\nfile = \"bonds.csv\"\ngap = 0.1", mm),
                 "lists every contact");
}

TEST_F(Inputs, OneTypeOfAllIsAMaterialWhereTheCaseHasIt) {
  folder_.write("row.csv", "id,type,x,y,z,r\n1,2,0,0,0,1e-3\n2,2,0,0,1.98e-3,1e-3\n");
  const auto material = [](const char* name, int density) {
    return std::string("[[materials]]\nname = \"") + name + "\"\ndensity = " + std::to_string(density) +
           "\nthermal = { conductivity = 1, specific_heat = 1 }\n";
  };
  const Scene scene = load("t_end = 1\n[packing]\nfile = \"row.csv\"\n[contact]\nneck = \"hertz\"\n" +
                           material("1", 1000) + material("2", 8000) + "[thermal]\n");
  EXPECT_NEAR(scene.fields[0].graph.capacity[0], 8000 * 4.18879e-9, 1e-10);
}

TEST_F(Inputs, MaterialsBySelection) {
  write_row();
  const auto scene = load("t_end = 1\n[packing]\nfile = \"row.csv\"\n[contact]\nneck = \"hertz\"\n" +
                          several("where = { ids = [1, 3] }", "where = { ids = [2, 4] }") + "[thermal]\n");
  const auto& capacity = scene.fields[0].graph.capacity;
  EXPECT_NEAR(capacity[0] / capacity[1], 8, 1e-12);
  EXPECT_EQ(capacity[0], capacity[2]);
  const auto head = std::string("t_end = 1\n[packing]\nfile = \"row.csv\"\n[contact]\nneck = \"hertz\"\n");
  expect_refused(head + several("where = { ids = [1, 3] }", "where = { ids = [2] }") + "[thermal]\n",
                 "particle 4 is in the selection of no material");
  expect_refused(head + several("where = { ids = [1, 3] }", "where = \"all\"") + "[thermal]\n",
                 "already in an earlier");
}

TEST_F(Inputs, APeriodicDumpIsARing) {
  std::string dump =
      "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n4\nITEM: BOX BOUNDS pp pp pp\n0 0.1\n0 0.1\n0 0.08\nITEM: "
      "ATOMS id type x y z radius\n";
  for (int k = 1; k <= 4; ++k)
    dump += std::to_string(k) + " 1 0.05 0.05 " + std::to_string(0.02 * k - 0.01) + " 0.0102\n";
  folder_.write("ring.dump", dump);
  const std::string held = "initial = 50\nfixed = [ { where = { ids = [1] }, value = 100.0 } ]";
  const auto ring = load(row_case(held, "neck = \"hertz\"", "file = \"ring.dump\""));
  EXPECT_EQ(ring.packed->contacts.size(), 4u);
  const auto value = values_at_end(ring);
  EXPECT_DOUBLE_EQ(value[1], value[3]) << "both are neighbours of the first";
  EXPECT_GT(value[1], value[2]);
  const auto open = load(row_case(held, "neck = \"hertz\"", "file = \"ring.dump\"\nperiodic = \"none\""));
  EXPECT_EQ(open.packed->contacts.size(), 3u);
  EXPECT_NE(open.warnings.front().find("periodic along xyz"), std::string::npos);
}

TEST_F(Inputs, AnUnknownIdIsAnsweredWithThoseThatThereAre) {
  write_row();
  folder_.write("e.txt", "3 7 2\n7 12 2\n");
  const std::string network = "t_end = 1\n[network]\nedges = \"e.txt\"\ncapacity = 1\n";
  expect_refused(row_case("fixed = [ { where = { ids = [0] }, value = 1 } ]"), "ids run from 1 to 4");
  expect_refused("probe = 9\n" + row_case(""), "ids run from 1 to 4");
  expect_refused(network + "fixed = [ { ids = [1], value = 1 } ]\n", "ids are 3, 7, 12");
  folder_.write("f.csv", "id,value\n1,0\n");
  expect_refused(network + "fixed = \"f.csv\"\n", "ids are 3, 7, 12");
}

TEST_F(Inputs, ANumberWithoutUnitIsFollowedByNoBlank) {
  std::string csv = "id,x,y,z,r\n";
  for (int k = 0; k < 125; ++k) csv += std::to_string(k) + "," + std::to_string(k) + ",0,0,0.01\n";
  folder_.write("row.csv", csv);
  std::string all;
  for (const auto& one : load(row_case("")).warnings) all += one + "\n";
  EXPECT_NE(all.find("smallest mean coordination is 0; usual values"), std::string::npos) << all;
}

TEST_F(Inputs, AStarterCaseRunsAndConductsAsThePackingDoes) {
  std::string csv = "x,y,z,radius\n";
  for (int k = 0; k < 8; ++k)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        csv +=
            std::to_string(1.9 * i) + "," + std::to_string(1.9 * j) + "," + std::to_string(1.9 * k) + ",1\n";
  const auto path = folder_.write("towers.csv", csv);
  PackingOptions options;
  options.length_unit = 1e-3;
  const auto packing = read_packing(path, options);
  StarterSettings settings{.file = "towers.csv"};
  settings.length_unit = "mm";
  EXPECT_EQ(starter_axis(packing, settings), 'z');
  const auto scene = load(starter_case(packing, settings));
  EXPECT_EQ(scene.packed->contacts.size(), 4u * 7 + 8 * 4);
  EXPECT_TRUE(effective_conductivity(scene, scene.fields[0]).value.has_value());
  folder_.write("towers.csv", "x,y,z,radius\n0,0,0,1\n0,0,2,1\n0,0,4,1\n0,0,6,1\n");
  const auto touching = load(starter_case(read_packing(path, options), settings));
  EXPECT_EQ(touching.packed->contacts.size(), 3u) << "a gap is given where particles only touch";
}

TEST_F(Inputs, AStarterCaseStartsFromTheTemperaturesOfTheFile) {
  const auto initial = [&](const std::string& names) {
    const auto path = folder_.write(
        "towers.csv",
        "x,y,z,radius," + names + "\n0,0,0,1,300,1\n0,0,1.9,1,310,1\n0,0,3.8,1,320,1\n0,0,5.7,1,330,1\n");
    PackingOptions options;
    options.length_unit = 1;
    const auto packing = read_packing(path, options);
    const auto text = starter_case(packing, {.file = "towers.csv"});
    if (text.find("initial = 293.15") != std::string::npos) return std::vector<double>{};
    const auto scene = load(text);
    const auto value = scene.values_on_nodes(0, 0, scene.initial);
    return std::vector<double>(value.begin() + 1, value.end() - 1);  // those between the held ends
  };
  for (const char* name : {"f_Temp[0]", "temperature", "T [K]", "Temp"})
    EXPECT_EQ(initial(std::string(name) + ",vx"), (std::vector<double>{310, 320})) << name;
  for (const char* names : {"T [degC],vx", "type,vx", "f_Temp[0],temp", "f_Temperature_rate,vx"})
    EXPECT_TRUE(initial(names).empty()) << names;
}

}  // namespace
}  // namespace superstep
