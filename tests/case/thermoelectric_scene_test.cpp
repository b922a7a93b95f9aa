/// Case files with two fields and with the terms that users ask for: what they build, and what they refuse.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "case/checks/effective.hpp"
#include "case/checks/health.hpp"
#include "case/scene.hpp"
#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using test::message_of;
using test::TemporaryFolder;

const std::string cases = std::string(SUPERSTEP_SOURCE_DIR) + "/cases/";

/// A row of six touching spheres along z, and two far away that touch each other.
class ThermoelectricCase : public ::testing::Test {
 protected:
  ThermoelectricCase() {
    std::string rows = "id,x,y,z,radius\n";
    for (int k = 0; k < 6; ++k) rows += std::to_string(k) + ",0,0," + std::to_string(0.95 * k) + ",0.5\n";
    rows += "6,5,0,1,0.5\n7,5,0,1.95,0.5\n";
    folder_.write("row.csv", rows);
  }

  static std::string with(const std::string& electric, const std::string& thermal,
                          const std::string& more = "") {
    return "t_end = 1.0\n" + more +
           "[packing]\nfile = \"row.csv\"\nlength_unit = \"mm\"\n[material]\ndensity = 5000.0\n"
           "[contact]\nneck = \"coble\"\n" +
           (electric.empty() ? "" : "[electric]\n" + electric) +
           (thermal.empty() ? "" : "[thermal]\n" + thermal);
  }
  Scene load(const std::string& text) { return load_scene(folder_.write("case.toml", text)); }
  std::string refusal(const std::string& text) {
    const auto path = folder_.write("case.toml", text);
    return message_of<InputError>([&] { (void)load_scene(path); });
  }

  TemporaryFolder folder_;
};

const std::string electrodes =
    "fixed = [ { where = { ids = [5] }, value = 1.0 }, { where = { ids = [0] }, value = 0.0 } ]\n";
const std::string steady = "mode = \"steady\"\nconductivity = 1e5\n" + electrodes;
const std::string transient = "conductivity = 1e5\nspecific_capacity = 1e3\n" + electrodes;
const std::string heat = "conductivity = 50.0\nspecific_heat = 500.0\n";

TEST_F(ThermoelectricCase, StateIsThePotentialThenTheTemperature) {
  const Scene scene = load(with(transient, heat));
  ASSERT_EQ(scene.rhs->fields().size(), 2U);
  EXPECT_EQ(scene.rhs->fields()[0].name, "potential");
  EXPECT_EQ(scene.rhs->fields()[1].name, "temperature");
  EXPECT_EQ(scene.rhs->fields()[0].count, 4U);  // two electrodes and an idle pair
  EXPECT_EQ(scene.rhs->fields()[1].count, 6U);  // the pair apart carries no current and stays as it is
  EXPECT_TRUE(scene.rhs->one_way() != nullptr);
}

TEST_F(ThermoelectricCase, WhatTwoFieldsFindOfAMaterialIsSaidOnce) {
  std::string light = with(transient, heat);
  light.replace(light.find("density = 5000.0"), 16, "density = 100.0");
  const auto warnings = load(light).warnings;
  EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(),
                          [](const auto& one) { return one.find("density") != std::string::npos; }),
            1);
}

TEST_F(ThermoelectricCase, SteadyPotentialIsSolvedOnceAndHeatsAtAConstantRate) {
  const Scene scene = load(with(steady, heat));
  ASSERT_EQ(scene.rhs->fields().size(), 1U);
  EXPECT_TRUE(scene.rhs->traits().linear);
  const auto potential = scene.values_on_nodes(0, 0.0, scene.initial);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(potential[k], 0.2 * static_cast<double>(k), 1e-12);
  // Five equal branches: V I = 1/(5 R).
  const double conductance = scene.fields[0].graph.conductance[0];
  EXPECT_NEAR(scene.rhs->inflow(0, scene.initial), conductance / 5, 1e-10 * conductance);
  const auto facts = electrode_facts(scene.fields[0], field_at_start(scene, scene.fields[0]));
  ASSERT_TRUE(facts && facts->resistance);
  EXPECT_NEAR(*facts->resistance, 5 / conductance, 1e-10 / conductance);
  EXPECT_NEAR(facts->current_in, facts->current_out, 1e-10 * facts->current_in);
  EXPECT_NEAR(facts->joule_heat, facts->voltage * facts->current_in, 1e-10 * facts->joule_heat);
}

/// The right-hand side heats by what flows, and shares no code with the facts.
TEST_F(ThermoelectricCase, ElectrodesConductAsTheTemperaturesAtTheStartLet) {
  const std::string feed = "source = [ { where = { ids = [2] }, value = 5.0 } ]\n";
  const std::string ramp =
      "fixed = [ { where = { ids = [5] }, value = { times = [0, 1], values = [1, 3] } }, { where = { ids = "
      "[0] }, value = { times = [0, 1], values = [0, -1] } } ]\n";
  for (const std::string law :
       {"1e5", "{ law = \"sigmoid\", value = 1e4, amplitude = 9.0, steepness = 0.1, reference = 350.0 }",
        "{ law = \"linear\", value = 1e5, coefficient = 0.01, reference = 300.0 }",
        "{ law = \"table\", temperatures = [200.0, 600.0], values = [1e4, 3e5] }"})
    for (const bool fed : {false, true})
      for (const auto& fixed : {electrodes, ramp}) {
        const Scene scene =
            load(with("mode = \"steady\"\nconductivity = " + law + "\n" + fixed + (fed ? feed : ""),
                      heat + "initial = 400.0\n"));
        const auto& field = scene.fields[0];
        const auto state = field_at_start(scene, field);
        const auto facts = electrode_facts(field, state);
        ASSERT_TRUE(facts) << law;
        const double joule = scene.rhs->inflow(0, scene.initial);
        EXPECT_NEAR(facts->joule_heat / joule, 1, 1e-8) << law << fed;
        EXPECT_EQ(state.temperatures, law == "1e5" ? "" : "400 K");
        EXPECT_EQ(facts->resistance.has_value(), !fed) << law;
        EXPECT_NEAR(facts->current_out - facts->current_in, fed ? 5 : 0, 1e-8 * facts->current_out) << law;
        const auto effective = effective_conductivity(scene, field);
        EXPECT_EQ(effective.value.has_value(), !fed) << law;
        EXPECT_EQ(effective.note.find("sources feed") != std::string::npos, fed) << effective.note;
        if (fed) continue;
        EXPECT_NEAR(*facts->resistance * joule, 1, 1e-8) << "V = 1: R = V^2/P";
        EXPECT_NEAR(effective.flow / joule, 1, 1e-8) << law;
      }
}

/// A case with the laws' values at the start as constants has the same conductances there.
TEST_F(ThermoelectricCase, StiffnessIsThatOfTheTemperaturesAtTheStart) {
  const std::string rest =
      "specific_heat = 500.0\ninitial = 400.0\nfixed = [ { where = { ids = [0, 6] }, value = 400.0 } ]\n";
  const Scene constant = load(with("", "conductivity = 100.0\n" + rest));
  const FieldHealth expected = assess_network(constant).fields.front();
  EXPECT_FALSE(expected.jacobian_bound);
  for (const char* law : {"{ law = \"linear\", value = 50.0, coefficient = 0.01, reference = 300.0 }",
                          "{ law = \"table\", temperatures = [200.0, 600.0], values = [1.0, 199.0] }"}) {
    const Scene scene = load(with("", std::string("conductivity = ") + law + "\n" + rest));
    const FieldHealth found = assess_network(scene).fields.front();
    EXPECT_EQ(found.temperatures, "400 K");
    EXPECT_NEAR(found.lambda_max / expected.lambda_max, 1, 1e-6) << law;
    EXPECT_NEAR(found.edge_bound / expected.edge_bound, 1, 1e-12) << law;
    EXPECT_NEAR(found.gershgorin / expected.gershgorin, 1, 1e-12) << law;
    EXPECT_NEAR(*found.lambda_min / *expected.lambda_min, 1, 1e-6) << law;
    EXPECT_NEAR(found.pair_step_bare / expected.pair_step_bare, 1, 1e-12) << law;
    EXPECT_NEAR(*found.lumping_median / *expected.lumping_median, 1, 1e-12) << law;
    ASSERT_TRUE(found.jacobian_bound);
    EXPECT_DOUBLE_EQ(found.certified_step(), 2 / scene.rhs->spectral_bound(0, scene.initial));
  }
}

/// They radiate so much more than they conduct that 4 e sigma A T^3/C is the fastest rate.
TEST_F(ThermoelectricCase, RadiationLimitsStepsToo) {
  const Scene scene = load(with("",
                                "conductivity = 1e-9\nspecific_heat = 500.0\ninitial = 1000.0\nradiation = [ "
                                "{ where = \"all\", emissivity = "
                                "1.0, ambient = 300.0 } ]\n"));
  const FieldHealth found = assess_network(scene).fields.front();
  const double rate = 4 * 5.670374419e-8 * 1e9 * 4 * 0.25e-6 / (5000.0 * 500.0 * 4.0 / 3.0 * 0.125e-9);
  EXPECT_NEAR(found.lambda_max / rate, 1, 1e-5);
  EXPECT_GE(std::min(found.edge_bound, found.gershgorin), found.lambda_max * (1 - 1e-9));
}

/// The row's electrodes differ later; the pair apart is held at another potential.
TEST_F(ThermoelectricCase, SteadyElectrodesThatAreEqualAtTheStartShareACluster) {
  const Scene scene = load(
      with("mode = \"steady\"\nconductivity = 1e5\nfixed = [ { where = { ids = [5] }, value = { times = [0, "
           "1], values = "
           "[0, 1] } }, { where = { ids = [0] }, value = 0.0 }, { where = { ids = [6] }, value = 1.0 } ]\n",
           heat));
  EXPECT_TRUE(scene.fields[0].steady);
}

TEST_F(ThermoelectricCase, SteadyPotentialThatMovesFollowsTheState) {
  const std::string rising =
      "mode = \"steady\"\nfixed = [ { where = { ids = [5] }, value = { times = [0.0, 1.0], values = [0.0, "
      "2.0] } }, "
      "{ where = { ids = [0] }, value = 0.0 } ]\n"
      "conductivity = { law = \"linear\", value = 1e5, coefficient = 0.5, reference = 0.0 }\n";
  Scene scene = load(with(rising, heat));
  ASSERT_NE(scene.moving_potential, nullptr);
  auto state = scene.initial;
  EXPECT_NEAR(scene.values_on_nodes(0, 0.5, state)[3], 0.6, 1e-12);
  EXPECT_NEAR(scene.values_on_nodes(0, 1.0, state)[5], 2.0, 1e-12);
  state[0] = 4.0;  // hot: its branches conduct better, and less voltage falls off there
  const auto moved = scene.values_on_nodes(0, 1.0, state);
  EXPECT_GT(std::abs(moved[3] - 1.2), 1e-3);
}

TEST_F(ThermoelectricCase, ASteadyPotentialAloneIsAnAnswerToo) {
  const Scene scene = load(with(steady, ""));
  EXPECT_EQ(scene.rhs->size(), 0U);
  EXPECT_NEAR(scene.values_on_nodes(0, 1.0, {})[2], 0.4, 1e-12);
}

TEST_F(ThermoelectricCase, ConvectionAndRadiationTakeTheSphereSurface) {
  const Scene scene =
      load(with("", heat + "initial = 400.0\nconvection = [ { where = { ids = [2] }, coefficient "
                           "= 10.0, ambient = 300.0 } ]\nradiation = [ { where = { ids = [3] }, "
                           "emissivity = 0.5, ambient = 300.0 } ]\n"));
  const double area = 4 * 3.14159265358979 * 0.25e-6;
  const double expected =
      -10 * area * 100 - 0.5 * 5.670374419e-8 * area * (std::pow(400, 4) - std::pow(300, 4));
  EXPECT_NEAR(scene.rhs->inflow(0, scene.initial), expected, 1e-9 * std::abs(expected));
  EXPECT_FALSE(scene.rhs->traits().linear);
  const auto radiation_skipped = [](const Skip& skip) { return skip.what == "radiation"; };
  EXPECT_EQ(std::count_if(scene.skips.begin(), scene.skips.end(), radiation_skipped), 0);
}

TEST_F(ThermoelectricCase, TwoEqualTimesAreAStep) {
  const Scene scene =
      load(with("", heat + "fixed = [ { where = { ids = [0] }, value = { times = [0.0, 0.5, 0.5], "
                           "values = [1.0, 1.0, 3.0] } } ]\n"));
  EXPECT_EQ(scene.values_on_nodes(0, 0.499, scene.initial)[0], 1);
  EXPECT_EQ(scene.values_on_nodes(0, 0.5, scene.initial)[0], 3);
  EXPECT_EQ(scene.fields[0].graph.tables[0].before(0.5), 1);
}

TEST_F(ThermoelectricCase, SaysWhatItSkips) {
  const Scene scene = load(with("", heat + "fixed = [ { where = { ids = [0] }, value = 1.0 } ]\n"));
  std::vector<std::string> whats;
  for (const auto& skip : scene.skips) whats.push_back(skip.what);
  for (const char* what : {"electric field", "convection", "radiation"})
    EXPECT_EQ(std::count(whats.begin(), whats.end(), what), 1) << what;
}

struct Refusal {
  std::string name, electric, thermal, expected;
};

class Refusals : public ThermoelectricCase, public ::testing::WithParamInterface<Refusal> {};

INSTANTIATE_TEST_SUITE_P(
    Bad, Refusals,
    ::testing::Values(
        Refusal{"NoSharedCluster",
                "mode = \"steady\"\nconductivity = 1.0\nfixed = [ { where = { ids = [0] }, value = 1.0 }, { "
                "where = "
                "{ ids = [6] }, value = 0.0 } ]\n",
                heat, "share no cluster"},
        Refusal{"NothingHeld", "mode = \"steady\"\nconductivity = 1.0\n", heat, "at least one fixed value"},
        Refusal{"SourceOnAFloatingCluster", steady + "source = [ { where = { ids = [7] }, value = 1.0 } ]\n",
                heat, "without a fixed potential"},
        Refusal{
            "Celsius", "",
            heat + "initial = 20.0\nradiation = [ { where = \"all\", emissivity = 0.5, ambient = 293.0 } ]\n",
            "looks like degrees Celsius"},
        Refusal{
            "BelowZero", "",
            heat + "initial = 300.0\nradiation = [ { where = \"all\", emissivity = 0.5, ambient = -5.0 } ]\n",
            ">= 0 K"},
        Refusal{
            "Emissivity", "",
            heat +
                "initial = 300.0\nradiation = [ { where = \"all\", emissivity = 1.5, ambient = 300.0 } ]\n",
            "between 0 and 1"},
        Refusal{"UnsortedTable", "",
                "specific_heat = 500.0\nconductivity = { law = \"table\", temperatures = [1.0, 0.5], values "
                "= [1.0, "
                "2.0] }\n",
                "ascending"},
        Refusal{
            "UnsortedTimes", "",
            heat + "source = [ { where = \"all\", value = { times = [1.0, 0.5], values = [1.0, 2.0] } } ]\n",
            "ascending, and 0.5 follows 1"},
        Refusal{"ThreeEqualTimes", "",
                heat + "source = [ { where = \"all\", value = { times = [1.0, 1.0, 1.0], values = [1.0, 2.0, "
                       "3.0] } } ]\n",
                "1 stands three times"},
        Refusal{"NegativeConductivityInTable", "",
                "specific_heat = 500.0\nconductivity = { law = \"table\", temperatures = [0.0, 1.0], values "
                "= [1.0, "
                "-2.0] }\n",
                "must be > 0"},
        Refusal{"UnknownLaw", "", "specific_heat = 500.0\nconductivity = { law = \"lineer\", value = 1.0 }\n",
                "did you mean 'linear'"},
        Refusal{"ZeroCapacity", "", "specific_heat = 0.0\nconductivity = 1.0\n", "specific_heat"},
        Refusal{"CapacityMissing", "conductivity = 1.0\n" + electrodes, heat, "specific_capacity"},
        Refusal{"LawWithoutTemperature",
                "conductivity = { law = \"linear\", value = 1.0, coefficient = 0.1, reference = 0.0 "
                "}\nspecific_capacity = 1.0\n" +
                    electrodes,
                "", "has no [thermal]"},
        Refusal{"UnknownMode", "mode = \"stationary\"\nconductivity = 1.0\n", heat, "\"steady\""}),
    [](const auto& refusal) { return refusal.param.name; });

TEST_P(Refusals, NamePlaceAndReason) {
  const auto message = refusal(with(GetParam().electric, GetParam().thermal));
  EXPECT_NE(message.find(GetParam().expected), std::string::npos) << message;
  EXPECT_NE(message.find("case.toml"), std::string::npos) << message;
}

TEST_F(ThermoelectricCase, CouplingNeedsTwoFields) {
  EXPECT_NE(refusal(with("", heat, "coupling = { joule_heat = true }\n")).find("only with"),
            std::string::npos);
}

TEST(ThermoelectricCases, ElectricFieldOfTheNialSampleIsThatOfThePaper) {
  const Scene scene = load_scene(cases + "nial_thermoelectric_steady.toml");
  const auto effective = effective_conductivity(scene, scene.fields[0]);
  ASSERT_TRUE(effective.value);
  EXPECT_NEAR(*effective.value / 4.518e5, 1, 0.05);  // published; the sample is another one
  double capacity = 0;
  for (const double c : scene.fields[1].graph.capacity) capacity += c;
  // Section 9.2: the temperature ends rising at 0.169 K/s.
  EXPECT_NEAR(scene.rhs->inflow(0, scene.initial) / capacity / 0.169, 1, 0.1);
}

bool has_knot(const Scene& scene, double t) {
  const auto& points = scene.rhs->facts().breakpoints;
  return std::any_of(points.begin(), points.end(), [t](const auto& point) { return point.t == t; });
}

/// Spheres 0, 1 and 2 are held, so that no free one feels sphere 1: but the current through its contacts
/// heats.
TEST_F(ThermoelectricCase, TablesAmongElectrodesAloneAreLandedOn) {
  const std::string pulsed =
      "fixed = [ { where = { ids = [0, 2] }, value = 0.0 }, { where = { ids = [1] }, value = { times = [0.0, "
      "0.25, 0.25, 0.75], values = [0.0, 0.0, 2.0, 0.0] } } ]\n";
  for (const std::string mode : {"specific_capacity = 1e3\n", "mode = \"steady\"\n"}) {
    const Scene scene = load(with("conductivity = 1e5\n" + mode + pulsed, heat + "initial = 300.0\n"));
    EXPECT_TRUE(has_knot(scene, 0.25) && has_knot(scene, 0.75)) << mode;
    EXPECT_FALSE(scene.rhs->traits().autonomous) << mode;
  }
}

/// Sphere 1 is held at temperatures that change, between others that are held: nothing feels it but the
/// conductivity of its contacts.
TEST_F(ThermoelectricCase, TemperaturesAmongHeldOnesAreLandedOnWhereALawFollowsThem) {
  const std::string law =
      "conductivity = { law = \"sigmoid\", value = 1e5, amplitude = 1.5, steepness = 0.05, reference = 320.0 "
      "}\nspecific_capacity = 1e3\n";
  const std::string held =
      "initial = 300.0\nfixed = [ { where = { ids = [0, 2] }, value = 300.0 }, { where = { ids = [1] }, "
      "value "
      "= { times = [0.0, 0.5, 0.5], values = [300.0, 300.0, 500.0] } } ]\n";
  const Scene scene = load(with(law + electrodes, heat + held));
  EXPECT_TRUE(has_knot(scene, 0.5));
  EXPECT_FALSE(scene.rhs->traits().autonomous);
}

}  // namespace
}  // namespace superstep
