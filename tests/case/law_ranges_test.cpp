/// Cases whose temperatures leave the range of a law of conductivity: refused with the place, the
/// temperature, the range and the way out.

#include "case/checks/law_ranges.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using test::message_of;
using test::TemporaryFolder;

const std::string falling =  // crosses zero at 800 K
    R"({ law = "linear", value = 50.0, coefficient = -2e-3, reference = 300.0 })";
const std::string falling_clamped =
    R"({ law = "linear", value = 50.0, coefficient = -2e-3, reference = 300.0, outside = "clamp" })";
const std::string rising =  // crosses zero at 50 K
    R"({ law = "linear", value = 50.0, coefficient = 4e-3, reference = 300.0, outside = "error" })";
const std::string table = R"({ law = "table", temperatures = [300.0, 800.0], values = [50.0, 20.0] })";
const std::string table_clamped =
    R"({ law = "table", temperatures = [300.0, 800.0], values = [50.0, 20.0], outside = "clamp" })";
const std::string sigmoid =
    R"({ law = "sigmoid", value = 50.0, amplitude = -0.9, steepness = 0.01, reference = 500.0 })";

/// Ten spheres in a row along x that overlap a little, of one material or of two in turn.
class LawRanges : public ::testing::Test {
 protected:
  LawRanges() {
    std::string one = "id,x,y,z,radius\n", two = "id,x,y,z,radius,material\n";
    for (int k = 0; k < 10; ++k) {
      one += fmt::format("{},{},0,0,0.5\n", k, 0.98 * k);
      two += fmt::format("{},{},0,0,0.5,{}\n", k, 0.98 * k, k % 2 ? "steel" : "brass");
    }
    folder_.write("row.csv", one);
    folder_.write("mixed.csv", two);
  }

  /// Empty when the case is accepted.
  std::string refusal(const std::string& text) {
    const auto path = folder_.write("case.toml", text);
    return message_of<InputError>([&] { (void)load_scene(path); });
  }
  Scene load(const std::string& text) { return load_scene(folder_.write("case.toml", text)); }

  TemporaryFolder folder_;
};

const std::string head =
    "t_end = 100.0\n[packing]\nfile = \"row.csv\"\nlength_unit = \"mm\"\n[material]\ndensity = 2500.0\n"
    "[contact]\nneck = \"hertz\"\n";

/// One material; the law stands on line 10.
std::string with(const std::string& law, const std::string& thermal) {
  return head + "[thermal]\nconductivity = " + law + "\nspecific_heat = 800.0\n" + thermal;
}

std::string held(const std::string& value) {
  return "initial = 300.0\nfixed = [ { where = { ids = [0] }, value = " + value +
         " }, { where = { ids = [9] }, value = 300.0 } ]\n";
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  for (const auto& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
}

TEST_F(LawRanges, AFixedTemperatureBeyondTheZeroOfALineIsRefused) {
  expect_parts(refusal(with(falling, held("1000.0"))),
               {"case.toml:10: key 'thermal.conductivity'", "the fixed temperature of particle 0 is 1000 K",
                "only below 800 K", "outside = \"clamp\""});
  expect_parts(refusal(with(falling, held("800.0"))), {"is 800 K", "only below 800 K"});
  EXPECT_EQ(refusal(with(falling, held("799.0"))), "");
}

TEST_F(LawRanges, AStartBeyondTheRangeIsRefused) {
  expect_parts(refusal(with(rising, "initial = 20.0\n")),
               {"the start temperature of particle 0 is 20 K", "only above 50 K"});
  expect_parts(refusal(with(table, "initial = 293.15\n")),
               {"the start temperature of particle 0 is 293.15 K", "from 300 K to 800 K"});
  EXPECT_EQ(refusal(with(table, "initial = 300.0\n")), "");
}

TEST_F(LawRanges, TablesOfTimeCountWithinTheRunAlone) {
  const auto rising_to = [](const char* times) {
    return held("{ times = " + std::string(times) + ", values = [300.0, 900.0] }");
  };
  expect_parts(refusal(with(falling, rising_to("[0.0, 100.0]"))), {"particle 0 is 900 K", "below 800 K"});
  EXPECT_EQ(refusal(with(falling, rising_to("[0.0, 200.0]"))), "");  // 600 K at t_end
  expect_parts(refusal(with(falling, held("{ times = [50.0, 50.0, 51.0, 51.0], values = [300.0, 900.0, "
                                          "900.0, 300.0] }"))),
               {"particle 0 is 900 K"});
}

TEST_F(LawRanges, SurroundingsThatLeadBeyondAreRefused) {
  const std::string start = "initial = 400.0\n";
  const auto convection = [](const std::string& where, const std::string& ambient) {
    return "convection = [ { where = " + where + ", coefficient = 10.0, ambient = " + ambient + " } ]\n";
  };
  expect_parts(refusal(with(falling, start + convection("{ ids = [4] }", "1500.0"))),
               {"the ambient (convection) of particle 4 is 1500 K", "below 800 K"});
  expect_parts(
      refusal(with(falling, start + "radiation = [ { where = { ids = [4] }, emissivity = 0.5, ambient = "
                                    "{ times = [0.0, 9.0], values = [400.0, 1500.0] } } ]\n")),
      {"the ambient (radiation) of particle 4 is 1500 K", "below 800 K"});
  EXPECT_EQ(refusal(with(falling, start + convection("\"all\"", "700.0"))), "");
  // A fixed particle does not approach its surroundings.
  EXPECT_EQ(refusal(with(falling, held("400.0") + convection("{ ids = [0] }", "1500.0"))), "");
}

TEST_F(LawRanges, ClampAndSigmoidTakeAnyTemperature) {
  EXPECT_EQ(refusal(with(falling_clamped, held("1000.0"))), "");
  EXPECT_EQ(refusal(with(table_clamped, held("1000.0"))), "");
  EXPECT_EQ(refusal(with(sigmoid, held("100000.0"))), "");
  const Scene scene = load(with(falling_clamped, held("1000.0")));
  EXPECT_EQ(scene.rhs->law_violation(std::vector<double>(scene.rhs->size(), 900.0)), std::nullopt);
}

TEST_F(LawRanges, UnknownChoicesAreRefused) {
  const std::string law =
      R"({ law = "table", temperatures = [1.0, 2.0], values = [1.0, 2.0], outside = "hold" })";
  expect_parts(refusal(with(law, "initial = 1.5\n")), {"thermal.conductivity.outside", "\"clamp\""});
}

TEST_F(LawRanges, OnlyParticlesOfTheMaterialCount) {
  const auto mixed = [](const std::string& thermal) {
    return "t_end = 100.0\n[packing]\nfile = \"mixed.csv\"\nlength_unit = \"mm\"\n[contact]\nneck = "
           "\"hertz\"\n"
           "[[materials]]\nname = \"brass\"\ndensity = 8000.0\nthermal = { specific_heat = 400.0, "
           "conductivity "
           "= 100.0 }\n[[materials]]\nname = \"steel\"\ndensity = 8000.0\nthermal = { specific_heat = 400.0, "
           "conductivity = " +
           falling + " }\n[thermal]\n" + thermal;
  };
  const auto hot = [](const char* ids) {
    return fmt::format("fixed = [ {{ where = {{ ids = {} }}, value = 1000.0 }} ]\n", ids);
  };
  EXPECT_EQ(refusal(mixed("initial = 300.0\n" + hot("[4]"))), "");
  expect_parts(refusal(mixed("initial = 300.0\n" + hot("[5]"))),
               {"fixed temperature of particle 5 is 1000 K", "below 800 K"});
  // The start of a fixed particle is never used: all of steel is held at 400 K.
  EXPECT_EQ(
      refusal(mixed("initial = 900.0\nfixed = [ { where = { ids = [1, 3, 5, 7, 9] }, value = 400.0 } ]\n")),
      "");
}

TEST_F(LawRanges, ElectricLawsCountWithTheTemperaturesOfTheirParticles) {
  const auto both = [](const std::string& electric_law, const std::string& thermal) {
    return head + "[electric]\nspecific_capacity = 1e3\nconductivity = " + electric_law +
           "\nfixed = [ { where = { ids = [0] }, value = 900.0 }, { where = { ids = [9] }, value = 0.0 } ]\n"
           "[thermal]\nspecific_heat = 800.0\nconductivity = 50.0\n" +
           thermal;
  };
  EXPECT_EQ(refusal(both(falling, "initial = 300.0\n")), "");  // 900 is a potential
  expect_parts(refusal(both(falling, "initial = 900.0\n")),
               {"key 'electric.conductivity'", "the start temperature of particle 0 is 900 K"});
}

TEST_F(LawRanges, AStateBeyondNamesTheParticleByItsId) {
  Scene scene = load(with(falling, "initial = 300.0\nsource = [ { where = { ids = [7] }, value = 1.0 } ]\n"));
  EXPECT_EQ(scene.rhs->law_violation(scene.initial), std::nullopt);
  auto state = scene.initial;
  state[static_cast<std::size_t>(scene.entry_of_node(0, 7))] = 812.5;
  const auto said = scene.rhs->law_violation(state);
  ASSERT_TRUE(said);
  expect_parts(*said, {"case.toml:10: key 'thermal.conductivity'",
                       "the temperature of node 7 has reached 812.5 K", "only below 800 K"});
}

}  // namespace
}  // namespace superstep
