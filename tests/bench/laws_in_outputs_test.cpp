/// What laws of temperature make of conductances, wherever these are given out.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "case/checks/health.hpp"
#include "case/scene.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/vtk/vtk_xml.hpp"
#include "support/program_fixture.hpp"

namespace superstep {
namespace {

constexpr const char* material =
    "[material]\ndensity = 5000\n[contact]\nneck = \"hertz\"\n[thermal]\nspecific_heat = 300\ninitial = "
    "350\n";
constexpr const char* ends =
    "fixed = [ { where = { ids = [0] }, value = 400 }, { where = { ids = [2] }, value = 300 } ]\n";

class LawsInOutputs : public test::Program {
 protected:
  void SetUp() override { folder_.write("p.csv", "id,x,y,z,radius\n0,0,0,0,1\n1,0,0,1.9,1\n2,0,0,3.8,1\n"); }
  /// Three spheres in a row, the outer ones held.
  void write_row(const std::string& law, const std::string& more = "") {
    folder_.write("c.toml",
                  "t_end = 1e4\noutput_times = [1e4]\n[packing]\nfile = \"p.csv\"\nlength_unit = \"mm\"\n" +
                      std::string(material) + "conductivity = " + law + "\n" + ends + more);
  }
};

/// In the steady state what enters the middle sphere leaves it.
TEST_F(LawsInOutputs, FluxesOfAFrameBalance) {
  write_row("{ law = \"linear\", value = 50, coefficient = -1e-3, reference = 0 }");
  ASSERT_EQ(run("run c.toml --vtk --quiet --tolerance 1e-8 --out o"), 0) << err();
  const std::string path = folder_.file("o/vtk/contacts_0001.vtp");
  const VtkPoints frame = read_vtk_xml(path, read_file(path), true);
  const auto find = [&](const std::string& name) {
    for (const auto& array : frame.lines_data)
      if (array.name == name) return array.value;
    return std::vector<double>{};
  };
  const auto flux = find("flux_temperature"), conductance = find("conductance_temperature");
  ASSERT_EQ(flux.size(), 2U);
  EXPECT_NEAR(flux[0] / flux[1], 1, 1e-6);
  // 1 - 1e-3 T at the ends and at T = (sqrt) between them: the conductances differ as the means do.
  EXPECT_GT(conductance[1] / conductance[0], 1.05);
}

/// The pair step is a fact of the start, in `info` and for forward-euler:alpha.
TEST_F(LawsInOutputs, PairStepsAreThoseOfTheStart) {
  for (const char* reference : {"0", "1000"}) {
    write_row(std::string("{ law = \"linear\", value = 50, coefficient = 4e-4, reference = ") + reference +
              " }");
    const Scene scene = load_scene(folder_.file("c.toml"));
    EXPECT_NEAR(scene.rhs->facts().pair_step / assess_network(scene).fields[0].pair_step_bare, 1, 1e-12)
        << reference;
  }
}

TEST_F(LawsInOutputs, ASystemOfTheStartSaysWhatItLeavesOut) {
  write_row(
      "{ law = \"linear\", value = 50, coefficient = -1e-3, reference = 0 }",
      "[electric]\nmode = \"steady\"\nconductivity = { law = \"linear\", value = 1e4, coefficient = 1e-3, "
      "reference = 0 }\nfixed = [ { where = { ids = [0] }, value = 1 }, { where = { ids = [2] }, value = 0 "
      "} ]\n");
  ASSERT_EQ(run("info c.toml --matrix m"), 0) << err();
  for (const char* said : {"conductivities are those of the start, at 300 to 400 K", "potential is steady",
                           "the heat of the current is left out"})
    EXPECT_NE(err().find(said), std::string::npos) << said << "\n" << err();
  EXPECT_NE(folder_.read("m/temperature_case.toml").find("the heat of the current"), std::string::npos);
}

/// Layers of a lattice that is joined to itself: the layers held touch each other across the joined side.
TEST_F(LawsInOutputs, AJoinedSideIsNoShortCut) {
  std::string spheres = "id,x,y,z,radius\n";
  int id = 0;
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x)
        spheres += fmt::format("{},{},{},{},0.52\n", id++, x + 0.5, y + 0.5, z + 0.5);
  folder_.write("q.csv", spheres);
  const auto conductivity = [&](const std::string& periodic, const char* which) {
    folder_.write(
        "c.toml",
        "t_end = 1\n[packing]\nfile = \"q.csv\"\nlength_unit = \"mm\"\nbox = { min = [0, 0, 0], max = [3, "
        "3, 4] }\nperiodic = \"" +
            periodic + "\"\n" + material +
            "conductivity = 50\nfixed = [ { where = \"top\", value = 400 }, { where = \"bottom\", value = "
            "300 } ]\n");
    EXPECT_EQ(run("info c.toml --json"), 0) << err();
    const auto json = nlohmann::json::parse(out());
    EXPECT_EQ(json["schema"], "superstep.health");
    const auto& value = json["fields"][0][which];
    return value.is_null() ? 0.0 : value.get<double>();
  };
  const double open = conductivity("xy", "effective_conductivity");
  EXPECT_GT(open, 0);
  EXPECT_EQ(conductivity("xy", "effective_conductivity_periodic"), 0) << "there is none";
  EXPECT_NEAR(conductivity("xyz", "effective_conductivity") / open, 1, 1e-9);
  EXPECT_NEAR(conductivity("xyz", "effective_conductivity_periodic") / open, 1, 1e-9)
      << "of a regular lattice";
}

TEST_F(LawsInOutputs, WhatDoesNothingIsRefused) {
  const auto refusal = [&](const std::string& contact, const std::string& thermal) {
    folder_.write("c.toml",
                  "t_end = 1\n[packing]\nfile = \"p.csv\"\nlength_unit = \"mm\"\n[material]\ndensity = "
                  "5000\n[contact]\n" +
                      contact + "\n[thermal]\nspecific_heat = 300\ninitial = 350\nconductivity = 50\n" +
                      thermal + ends);
    EXPECT_EQ(run("run c.toml --quiet --out o"), 3);
    return err();
  };
  const std::string layer = "grain_boundary = { thickness = 1e-8, reduction = 1e-3 }\n";
  EXPECT_NE(refusal("neck = \"hertz\"\nconductance = \"pipe\"", layer).find("has none"), std::string::npos)
      << err();
  EXPECT_NE(refusal("neck = \"hertz\"\nhardening = 1.0", "").find("takes none"), std::string::npos) << err();
}

TEST_F(LawsInOutputs, AStartAtZeroAmongAbsoluteTemperaturesIsWarnedOf) {
  folder_.write("c.toml",
                "t_end = 1\n[packing]\nfile = \"p.csv\"\nlength_unit = \"mm\"\n[material]\ndensity = "
                "5000\n[contact]\nneck = \"hertz\"\n[thermal]\nspecific_heat = 300\nconductivity = 50\n" +
                    std::string(ends));
  ASSERT_EQ(run("run c.toml --out o"), 0) << err();
  EXPECT_NE(err().find("initial is left out"), std::string::npos) << err();
}

/// A cluster with surroundings does not hold another that has none.
TEST_F(LawsInOutputs, ClustersAdriftAreWarnedOfOneByOne) {
  folder_.write("p.csv", "id,x,y,z,radius\n0,0,0,0,1\n1,0,0,1.9,1\n2,9,0,0,1\n3,9,0,1.9,1\n");
  folder_.write("c.toml",
                "t_end = 1\n[packing]\nfile = \"p.csv\"\nlength_unit = \"mm\"\n" + std::string(material) +
                    "conductivity = 50\nsource = [ { where = { ids = [0] }, value = 1e-3 } ]\n"
                    "convection = [ { where = { ids = [2] }, coefficient = 10, ambient = 300 } ]\n");
  ASSERT_EQ(run("run c.toml --out o"), 0) << err();
  EXPECT_NE(err().find("1 cluster without a fixed temperature"), std::string::npos) << err();
}

TEST_F(LawsInOutputs, SeveralRunsAreOneDocument) {
  write_row("50");
  ASSERT_EQ(run("run c.toml --integrator rkc cvode --json --quiet --out o"), 0) << err();
  const auto json = nlohmann::json::parse(out());
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[1]["integrator"], "cvode");
}

/// Steps of a method without a tolerance do not depend on who runs it.
TEST_F(LawsInOutputs, BenchStepsAsRunDoes) {
  write_row("{ law = \"linear\", value = 50, coefficient = 5e-3, reference = 300 }",
            "[bench]\nintegrators = [\"forward-euler:fraction=1\"]\n");
  ASSERT_EQ(run("run c.toml --integrator forward-euler:fraction=1 --json --quiet --out o"), 0) << err();
  const auto alone = nlohmann::json::parse(out())["counts"]["steps"].get<int>();
  ASSERT_EQ(run("bench c.toml --repetitions 1 --json --quiet --no-cache --out b"), 0) << err();
  const auto bench = nlohmann::json::parse(out());
  EXPECT_NE(bench.dump().find("\"steps\":" + std::to_string(alone) + ","), std::string::npos) << alone;
}

}  // namespace
}  // namespace superstep
