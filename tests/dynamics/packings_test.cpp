/// Packings of other programs, sizes and materials under motion.

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "case/press/press.hpp"
#include "core/error.hpp"
#include "dynamics/moving_network.hpp"
#include "press.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using namespace test;

const char* const dump =
    "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n"
    "ITEM: ATOMS id x y z radius\n1 0 0 0 9\n"
    "ITEM: TIMESTEP\n10\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n"
    "ITEM: ATOMS id type x y z vx vy vz radius f_Temp[0]\n"
    "7 2 100 0 100 1 2 3 50 400\n3 1 0 0 100 0 0 -5 50 500\n5 1 0 100 100 0 0 0 40 600\n";

std::string case_text(const std::string& particles,
                      const std::string& materials = "[material]\ndensity = 2000.0\n",
                      const std::string& thermal = "conductivity = 10.0\nspecific_heat = 100.0\n",
                      const std::string& more = "") {
  return "t_end = 1.0\n" + materials + "[thermal]\n" + thermal + "initial = 300.0\nwalls = 300.0\n" + more +
         "[dynamics]\n[dynamics.box]\nmin = [-1.0, -1.0, -1.0]\nmax = [1.0, 1.0, 1.0]\n" +
         "[dynamics.contact]\nstiffness = 1e7\n[dynamics.wall]\nstiffness = 1e7\n" +
         "[dynamics.bond]\nrule = \"rest-length\"\nstiffness = 1e7\nthreshold = 0.1\n"
         "growth = { rate = 1.0 }\n" +
         "[[dynamics.phases]]\nname = \"all\"\nuntil = 1.0\n[dynamics.particles]\n" + particles;
}

std::size_t place_of(const Press& press, std::int64_t id) {
  const auto& ids = press.particles.id;
  return static_cast<std::size_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
}

TEST(ParticleFile, DumpBringsVelocitiesAndTemperaturesOfItsLastFrame) {
  const TemporaryFolder folder;
  folder.write("p.dump", dump);
  const Press press = load_press(folder.write(
      "case.toml", case_text("file = \"p.dump\"\nlength_unit = \"mm\"\nshift = [0.0, 0.0, -0.5]\n")));
  ASSERT_EQ(press.particles.size(), 3U);
  const std::size_t k = place_of(press, 7);
  EXPECT_DOUBLE_EQ(press.particles.radius[k], 0.05);
  EXPECT_DOUBLE_EQ(press.state.position[k].x, 0.1);
  EXPECT_DOUBLE_EQ(press.state.position[k].z, 0.1 - 0.5);
  EXPECT_DOUBLE_EQ(press.state.velocity[k].y, 2e-3);
  EXPECT_EQ(press.state.temperature[k], 400);
  EXPECT_EQ(press.state.temperature[place_of(press, 5)], 600);
}

TEST(ParticleFile, TableBringsWhatItsColumnsSay) {
  const TemporaryFolder folder;
  folder.write("p.csv",
               "id,x,y,z,r,temperature,vx,vy,vz\n7,0.1,0,0,0.04,450,0,0,-1\n3,0,0,0,0.04,350,2,0,1\n");
  const auto loaded = [&](const std::string& more = "") {
    return load_press(folder.write("case.toml", case_text("file = \"p.csv\"\n" + more)));
  };
  const Press press = loaded();
  EXPECT_EQ(press.state.velocity[place_of(press, 7)].z, -1);
  EXPECT_EQ(press.state.velocity[place_of(press, 3)].x, 2);
  EXPECT_EQ(press.state.temperature[place_of(press, 3)], 350);
  EXPECT_EQ(loaded("velocity_unit = 0.5\n").state.velocity[0].z, 0.5) << "0.5 m/s each";
  for (const auto& [text, says] :
       {std::pair{"id,x,y,z,r,vx,vy\n7,0.1,0,1,0.04,1,2\n", "p.csv:1: has velocities, but none along z"},
        std::pair{"id,x,y,z,r,vx,vy,vz\n7,0.1,0,1,0.04,1,2,\n",
                  "particle 7 has no number in its column 'vz'"},
        std::pair{"id,x,y,z,r,temperature\n7,0.1,0,0,0.04,-1\n", "must be >= 0 K"}}) {
    folder.write("p.csv", text);
    const std::string message = message_of<InputError>([&] { (void)loaded(); });
    EXPECT_NE(message.find(says), std::string::npos) << message;
  }
}

TEST(ParticleFile, UnitsAndIndicesOfItsColumnsAreRead) {
  const TemporaryFolder folder;
  const auto load = [&](const std::string& content, const std::string& more = "") {
    folder.write("p.csv", content);
    return load_press(folder.write("case.toml", case_text("file = \"p.csv\"\n" + more)));
  };
  const std::string row = "\n7,0.1,0,0,0.04,1000,0,-500,450\n";
  const std::string units = "id,x,y,z,r,vx [mm/s],vy [mm/s],vz [mm/s],temperature [K]";
  EXPECT_EQ(load(units + row).state.velocity[0].z, -0.5);
  EXPECT_EQ(load(units + row).state.temperature[0], 450);
  EXPECT_EQ(load("id,x,y,z,r,v[0],v[1],v[2],T" + row).state.velocity[0].x, 1000);
  EXPECT_EQ(load("id,x,y,z,r,a,b,c,t" + row).state.temperature[0], 300) << "a time";
  const auto refused = [&](const std::string& content, const std::string& more, const std::string& says) {
    const std::string message = message_of<InputError>([&] { (void)load(content, more); });
    EXPECT_NE(message.find(says), std::string::npos) << message;
  };
  refused("id,x,y,z,r,vx,vy,vz,temperature\n7,0.1,0,0,0.04,0,0,0,hot\n", "", "'temperature' holds text");
  refused("id,x,y,z,r,vx [m/h],vy [m/h],vz [m/h],T" + row, "", "is in m/h");
  refused(units + row, "velocity_unit = 1.0\n", "another unit than velocity_unit");
}

TEST(ParticleFile, WhatAPressCannotUseIsSaid) {
  const TemporaryFolder folder;
  folder.write("p.dump", dump);
  const Press press = load_press(folder.write(
      "case.toml", case_text("file = \"p.dump\"\nlength_unit = \"mm\"\nshift = [0.0, 0.0, -0.5]\n")));
  const auto says = [&](const std::string& part) {
    return std::any_of(press.warnings.begin(), press.warnings.end(),
                       [&](const auto& one) { return one.find(part) != std::string::npos; });
  };
  EXPECT_TRUE(says("periodic along xyz, and a press has walls instead"));
  EXPECT_TRUE(says("the last of 2 frames"));
  folder.write("p.csv", "x,y,z,r,temperature [C]\n0,0,0,0.04,25\n");
  const std::string message = message_of<InputError>(
      [&] { (void)load_press(folder.write("case.toml", case_text("file = \"p.csv\"\n"))); });
  EXPECT_NE(message.find("'temperature [C]' is in C"), std::string::npos) << message;
  folder.write("p.csv", "x,y,z,r,temperature [K]\n0,0,0,0.04,25\n");
  EXPECT_EQ(load_press(folder.write("case.toml", case_text("file = \"p.csv\"\n"))).state.temperature[0], 25);
}

TEST(ParticleFile, ColumnsThatAPressMakesNoUseOfAreNamed) {
  const TemporaryFolder folder;
  const auto warnings = [&](const std::string& columns, const std::string& values) {
    folder.write("p.csv", "id,x,y,z,r," + columns + "\n7,0.1,0,0,0.04," + values + "\n");
    const auto press = load_press(folder.write("case.toml", case_text("file = \"p.csv\"\n")));
    return fmt::format("{}", fmt::join(press.warnings, "\n"));
  };
  EXPECT_NE(warnings("density", "7000").find("p.csv:1: a press makes no use of its column 'density'"),
            std::string::npos);
  EXPECT_NE(warnings("fx,vx,vy,vz,omegax,mass,T", "1,2,3,4,5,6,7").find("its columns 'fx', 'omegax', 'mass'"),
            std::string::npos);
  EXPECT_EQ(warnings("current,temperature,vx,vy,vz", "1,300,0,0,0"), "") << "what a press writes";
}

TEST(ParticleFile, TwoColumnsOfOneQuantityMustAgree) {
  const TemporaryFolder folder;
  const auto load = [&](const std::string& columns, const std::string& values) {
    folder.write("p.csv", "id,x,y,z,r," + columns + "\n7,0.1,0,0,0.04," + values + "\n");
    return load_press(folder.write("case.toml", case_text("file = \"p.csv\"\n")));
  };
  for (const auto& [columns, values, pair] :
       {std::tuple{"T,temperature", "320,1", "'temperature' and 'T'"},
        std::tuple{"Temp,f_Temp[0]", "320,321", "'Temp' and 'f_Temp[0]'"},
        std::tuple{"vx,vy,vz,velocity:0,velocity:1,velocity:2", "1,2,3,1,2,4", "'vz' and 'velocity:2'"},
        std::tuple{"vx,vy,vz,v_x [mm/s]", "1,2,3,1", "'vx' and 'v_x [mm/s]'"}}) {
    const std::string message = message_of<InputError>([&] { (void)load(columns, values); });
    EXPECT_NE(message.find(pair), std::string::npos) << message;
    EXPECT_NE(message.find("contradict each other: particle 7 has"), std::string::npos) << message;
    EXPECT_NE(message.find("p.csv:1: "), std::string::npos) << message;
  }
  const Press press = load("T,temperature,vx,vy,vz,v_x [mm/s]", "320,320,1,2,3,1000");
  EXPECT_EQ(press.state.temperature[0], 320);
  EXPECT_EQ(press.state.velocity[0].x, 1);
  EXPECT_TRUE(press.warnings.empty()) << press.warnings.front();
}

TEST(ParticleFile, EveryFormatBringsItsVelocities) {
  const TemporaryFolder folder;
  // Two particles each, ids 1 and 2 or 0 and 1; the first moves with (1, 2, 3).
  const std::vector<std::pair<std::string, std::string>> files = {
      {"data",
       "t\n\n2 atoms\n1 atom types\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms # sphere\n\n"
       "1 1 0.1 2000 0.2 0.2 0.2\n2 1 0.1 2000 0.5 0.5 0.5\n\nVelocities\n\n2 0 0 0 0 0 0\n"
       "1 1 2 3 0 0 0\n"},
      {"mercury.data",
       "2 0 0 0 0 1 1 1\n0.2 0.2 0.2 1 2 3 0.05 0 0 0 0 0 0 0\n"
       "0.5 0.5 0.5 0 0 0 0.05 0 0 0 0 0 0 0\n"},
      {"p.xyz",
       "2\nProperties=pos:R:3:radius:R:1:velo:R:3\n0.2 0.2 0.2 0.05 1 2 3\n0.5 0.5 0.5 0.05 0 0 0\n"},
      {"p.vtk",
       "# vtk DataFile Version 3.0\np\nASCII\nDATASET POLYDATA\nPOINTS 2 double\n0.2 0.2 0.2\n"
       "0.5 0.5 0.5\nPOINT_DATA 2\nSCALARS radius double 1\nLOOKUP_TABLE default\n0.05\n0.05\n"
       "VECTORS velocity double\n1 2 3\n0 0 0\n"},
  };
  for (const auto& [name, text] : files) {
    folder.write(name, text);
    const Press press = load_press(folder.write("case.toml", case_text("file = \"" + name + "\"\n")));
    const std::size_t k = press.state.position[0].x < 0.3 ? 0 : 1;
    EXPECT_EQ(press.state.velocity[k].x, 1) << name;
    EXPECT_EQ(press.state.velocity[k].y, 2) << name;
    EXPECT_EQ(press.state.velocity[k].z, 3) << name;
    EXPECT_EQ(norm(press.state.velocity[1 - k]), 0) << name;
  }
}

/// Source of the expected values: the LAMMPS command `units`.
TEST(ParticleFile, VelocitiesAreInTheUnitsOfTheirStyle) {
  const TemporaryFolder folder;
  const auto load = [&](const std::string& style, const std::string& more = "") {
    std::string text = dump;
    for (std::size_t at = 0; (at = text.find("ITEM: TIMESTEP", at)) != std::string::npos; at += 40)
      text.insert(at, "ITEM: UNITS\n" + style + "\n");
    folder.write("p.dump", text);
    return load_press(folder.write("case.toml", case_text("file = \"p.dump\"\n" + more)));
  };
  const auto velocity = [](const Press& press) { return press.state.velocity[place_of(press, 7)].y; };
  EXPECT_DOUBLE_EQ(velocity(load("micro")), 2) << "micrometres a microsecond";
  EXPECT_DOUBLE_EQ(velocity(load("metal")), 200) << "Angstroms a picosecond";
  EXPECT_DOUBLE_EQ(velocity(load("micro", "velocity_unit = 0.5\n")), 1) << "the case says otherwise";
  const std::string message = message_of<InputError>([&] { (void)load("electron"); });
  EXPECT_NE(message.find("velocity_unit"), std::string::npos) << message;
}

/// In a row: 1 and 2 overlap by 0.1 of the sum of their radii, 2 and 3 by a third.
TEST(ParticleFile, TheDeepestOverlapIsSaidWithTheLimitThatAllowsIt) {
  const TemporaryFolder folder;
  const std::string row = "id,x,y,z,r\n1,0,0,0,0.1\n2,0.18,0,0,0.1\n3,0.38,0,0,0.2\n";
  const auto complaint = [&](const std::string& text, const std::string& more = "") {
    folder.write("p.csv", text);
    const auto path = folder.write("case.toml", case_text("file = \"p.csv\"\n" + more));
    return message_of<InputError>([&] { (void)load_press(path); });
  };
  for (const auto& [more, limit] : {std::pair{"", "without max_overlap they may touch"},
                                    std::pair{"max_overlap = 0.2\n", "max_overlap is 0.2"}}) {
    const std::string message = complaint(row, more);
    EXPECT_NE(message.find("particle 2 at (0.18, 0, 0) m and particle 3"), std::string::npos) << message;
    EXPECT_NE(message.find("overlap by 0.3333 of the sum"), std::string::npos) << message;
    EXPECT_NE(message.find(limit), std::string::npos) << message;
    EXPECT_NE(message.find("max_overlap = 0.3334"), std::string::npos) << message;
  }
  EXPECT_EQ(complaint(row, "max_overlap = 0.3334\n"), "") << "what the message names is enough";
  const std::string wall = complaint(row + "4,0.95,0,0,0.1\n", "max_overlap = 0.4\n");
  EXPECT_NE(wall.find("particle 4 at (0.95, 0, 0) m overlaps the +x wall by 0.5"), std::string::npos) << wall;
  const std::string same = complaint(row + "4,0.3800001,0,0,0.2\n");
  EXPECT_NE(same.find("move them apart"), std::string::npos) << same;
  EXPECT_EQ(same.find("allow it"), std::string::npos) << "max_overlap is below 1: " << same;
}

TEST(ParticleFile, BondsBesideItAreTakenUp) {
  const TemporaryFolder folder;
  folder.write("p.csv", "id,x,y,z,radius\n7,0.1,0,0,0.06\n3,0,0,0,0.06\n");
  const std::string with = "file = \"p.csv\"\nbonds = \"b.csv\"\nmax_overlap = 0.3\n";
  folder.write("b.csv", "i,j,overlap,growth\n7,3,0.2,0.4\n");
  const Press press = load_press(folder.write("case.toml", case_text(with)));
  ASSERT_EQ(press.state.bonds.size(), 1U);
  EXPECT_EQ(press.state.bonds[0].i, 0);
  EXPECT_EQ(press.state.bonds[0].j, 1);
  EXPECT_EQ(press.state.bonds[0].growth, 0.4);
  // The neck acts from the start: x = 0.2 - 1/6, beyond the unloading strain.
  MovingNetwork network(press.model, press.particles);
  State state = press.state;
  network.resume(state, press.model.schedule.at(0));
  const double neck_area = pair_area(0.12 * 0.8, 0.06, 0.06);
  EXPECT_NEAR(network.contacts().table().pull[0], 0.4 * 1e7 * neck_area * (0.2 - 1.0 / 6), 1e-9 * 1e7);

  EXPECT_TRUE(press.warnings.empty()) << press.warnings.front();
  folder.write("p.csv", "id,x,y,z,radius\n7,0.1,0,0,0.06\n3,0,0,0,0.06\n9,0.6,0,0,0.06\n");
  folder.write("b.csv", "i,j,overlap,growth\n7,3,0.2,0.4\n3,9,0.2,0.4\n9,7,0.2,0.4\n");
  const auto warnings = load_press(folder.write("case.toml", case_text(with))).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("b.csv: 2 bonds break at once"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("has a strain of 4, its particles being 0.6 m apart"), std::string::npos)
      << warnings[0];

  for (const auto& [text, says] : {std::pair{"i,j,overlap,growth\n7,3,0.2,0.4\n3,7,0.2,0.4\n",
                                             "b.csv:3: the bond 7-3 has a row already, on line 2; keep one"},
                                   std::pair{"i,j,overlap,growth\n7,3,0.2,1.4\n", "[0, 1]"},
                                   std::pair{"i,j,overlap,growth\n7,8,0.2,0.4\n", "not in the packing"},
                                   std::pair{"i,j,overlap,growth\n7,7,0.2,0.4\n", "joins two"}}) {
    folder.write("b.csv", text);
    const std::string path = folder.write("case.toml", case_text(with));
    const std::string message = message_of<InputError>([&] { (void)load_press(path); });
    EXPECT_NE(message.find(says), std::string::npos) << message;
  }
}

TEST(ParticleMaterials, EachHasItsOwnNumbers) {
  const TemporaryFolder folder;
  folder.write("p.dump", dump);
  const std::string materials =
      "[[materials]]\nname = \"1\"\ndensity = 1000.0\nthermal = { conductivity = 1.0, specific_heat = 10.0 "
      "}\n"
      "[[materials]]\nname = \"2\"\ndensity = 3000.0\nthermal = { conductivity = 3.0, specific_heat = 30.0 "
      "}\n"
      "hardness = 2.0\n";
  const Press press = load_press(
      folder.write("case.toml", case_text("file = \"p.dump\"\nlength_unit = \"mm\"\n", materials, "")));
  const std::size_t k = place_of(press, 7);
  EXPECT_DOUBLE_EQ(press.particles.mass[k], 3000 * 4.0 / 3 * std::numbers::pi * std::pow(0.05, 3));
  EXPECT_EQ(press.particles.conductivity[k], 3);
  EXPECT_EQ(press.particles.specific_heat[place_of(press, 3)], 10);
  EXPECT_EQ(press.particles.hardness[k], 2);
  const std::string both = folder.write(
      "both.toml", case_text("file = \"p.dump\"\nlength_unit = \"mm\"\n", materials, "conductivity = 1.0\n"));
  EXPECT_NE(message_of<InputError>([&] { (void)load_press(both); }).find("remove it here"),
            std::string::npos);
}

TEST(ParticleSizes, FollowTheirDistribution) {
  const TemporaryFolder folder;
  const Press press = load_press(folder.write(
      "case.toml",
      case_text("count = 200\nsizes = { distribution = \"uniform\", min = 0.04, max = 0.12 }\nseed = 3\n")));
  const auto [low, high] = std::minmax_element(press.particles.radius.begin(), press.particles.radius.end());
  EXPECT_LT(*low, 0.021);
  EXPECT_GT(*high, 0.059);
  double sum = 0;
  for (const double r : press.particles.radius) sum += r;
  EXPECT_NEAR(sum / 200, 0.04, 1e-12) << "stratified: the mean is exact for a uniform law";
  for (std::size_t i = 0; i < press.particles.size(); ++i)
    for (std::size_t j = i + 1; j < press.particles.size(); ++j)
      ASSERT_GE(norm(press.state.position[i] - press.state.position[j]),
                (press.particles.radius[i] + press.particles.radius[j]) * (1 - 1e-12));
}

}  // namespace
}  // namespace superstep
